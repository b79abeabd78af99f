#include "result/fields.h"
