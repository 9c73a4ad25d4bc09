// PLACEHOLDER of the sweep's front door (owner: plane)
#pragma once
