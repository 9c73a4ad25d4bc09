/**
 * What goes wrong. `code` is a name such as 'BAD_SHAPE'; the last three are empty or 0 if the
 * error is about no text.
 */
export class PlumbError extends Error {
  constructor(code, message, {text = message, file = '', line = 0, column = 0} = {}) {
    super(text);
    this.name = 'PlumbError';
    this.code = code;
    this.reason = message;
    this.file = file;
    this.line = line;
    this.column = column;
  }
}
