# Sourced by the launchers: installs sections of packages.debian.txt.

# packages_of SECTION...: their names, one a line.
packages_of() {
  awk -v wanted=" $* " '
    /^# \[.*\]/ { section = substr($2, 2, length($2) - 2); next }
    /^#/ || NF == 0 { next }
    index(wanted, " " section " ") { print $1 }' "$root/packages.debian.txt"
}

# missing_packages SECTION...: those that dpkg does not have installed.
missing_packages() {
  packages_of "$@" | while read -r name; do
    case "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" in
      installed) ;;
      *) echo "$name" ;;
    esac
  done
}

# require_packages SECTION...: installs what is missing, as root; else says how and exits 2. Not on
# Debian: leaves it to cmake to say what it does not find.
require_packages() {
  command -v dpkg-query >/dev/null && command -v apt-get >/dev/null || return 0
  local missing
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" != 0 ]; then
    echo "Packages are missing. As root:" >&2
    echo "apt-get update && apt-get install -y --no-install-recommends" $missing >&2
    exit 2
  fi
  # One at a time on a machine: apt-get update does not wait for another one.
  (
    flock 8
    export DEBIAN_FRONTEND=noninteractive
    apt-get -q update && apt-get -q install -y --no-install-recommends $missing
  ) >&2 8</var/lib/dpkg || {
    echo "apt-get could not install:" $missing >&2
    exit 2
  }
}
