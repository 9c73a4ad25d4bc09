/* Ctrl-C on Windows: windows_interrupt_test PLUMB SOLID OUTPUT
 *
 * starts `PLUMB convex minkowski SOLID SOLID -o OUTPUT`, which takes minutes, and presses Ctrl-C
 * after two seconds. It passes if the program ends with status 4 within ten seconds, which include
 * the time that an emulator takes, and has written no file. */
#include <stdio.h>
#include <windows.h>

enum { kCancelled = 4 };

int main(int count, char** words) {
  if (count != 4) return 2;
  /* Ctrl-C goes to all programs of a console. This program has a console of its own, and ignores
   * Ctrl-C only after it has started the other program, which would inherit that. */
  FreeConsole();
  if (!AllocConsole()) return printf("there is no console\n"), 1;
  char line[4096];
  snprintf(line, sizeof(line), "\"%s\" convex minkowski \"%s\" \"%s\" -o \"%s\" --quiet", words[1],
           words[2], words[2], words[3]);
  STARTUPINFOA start = {.cb = sizeof(start)};
  PROCESS_INFORMATION program;
  if (!CreateProcessA(NULL, line, NULL, NULL, FALSE, 0, NULL, NULL, &start, &program))
    return printf("cannot start %s\n", line), 1;
  if (WaitForSingleObject(program.hProcess, 2000) != WAIT_TIMEOUT)
    return printf("it ended before it was interrupted\n"), 1;
  SetConsoleCtrlHandler(NULL, TRUE);
  if (!GenerateConsoleCtrlEvent(CTRL_C_EVENT, 0)) return printf("cannot press Ctrl-C\n"), 1;
  if (WaitForSingleObject(program.hProcess, 10000) != WAIT_OBJECT_0) {
    TerminateProcess(program.hProcess, 1);
    return printf("it does not end\n"), 1;
  }
  DWORD status = 0;
  GetExitCodeProcess(program.hProcess, &status);
  if (status != kCancelled) return printf("it ended with status %lu\n", status), 1;
  if (GetFileAttributesA(words[3]) != INVALID_FILE_ATTRIBUTES)
    return printf("it has written a file\n"), 1;
  return 0;
}
