#include "runs/commands/program.h"

int main(const int argc, const char *const *argv)
{
  return dpcontact::run_program(argc, argv, nullptr);
}
