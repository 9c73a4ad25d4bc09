/* Uses the installed C interface as a C99 program does. */
#include <plumb.h>
#include <stdio.h>
#include <string.h>

int main(void) {
  plumb_solid* ball = NULL;
  plumb_numbers* volume = NULL;
  int is_right = 0;
  if (plumb_abi_version() == PLUMB_ABI_VERSION && !plumb_solid_ball(1.0, 0, &ball, NULL) &&
      !plumb_solid_volume(ball, &volume, NULL, NULL)) {
    is_right = !strcmp(plumb_numbers_exact(volume, 0), "4/3");
    printf("plumb %s: volume %s\n", plumb_version(), plumb_numbers_exact(volume, 0));
  }
  plumb_numbers_free(volume);
  plumb_solid_free(ball);
  return is_right ? 0 : 1;
}
