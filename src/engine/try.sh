#!/bin/sh
# Starts the program of docs/using.md in a scratch project for each way that the page tells, with the blocks of code of
# the page itself. Called by "./rigibo install --try": DIR, which holds the installed engine in DIR/repository, and needs
# JAVA_HOME. Maven fetches its plugins.
set -eu

page=$(dirname "$0")/../../docs/using.md
scratch=$1
repository=$scratch/repository
engine=$(find "$repository" -name 'rigibo-engine-*.jar' ! -name '*-sources.jar' ! -name '*-javadoc.jar')
PATH=$JAVA_HOME/bin:$PATH

# The Nth block of code in a language.
block() {
    awk -v language="$1" -v wanted="$2" '
        /^```/ { if (inside) inside = 0; else { inside = 1; hit = $0 == "```" language && ++count == wanted; next } }
        inside && hit' "$page"
}

# A project of its own, and the engine in it under the name that the page gives it.
project() {
    mkdir -p "$scratch/$1"
    cd "$scratch/$1"
}

passed() {
    case $2 in
        'at rest after '*) echo "$1: $2" ;;
        *)
            echo "$1 failed: $2" >&2
            exit 1 ;;
    esac
}

project class-path
cp "$engine" rigibo-engine.jar
block java 1 >Drop.java
block sh 1 >try.sh
passed 'class path' "$(sh -eu try.sh)"

project module-path
mkdir drop
cp "$engine" rigibo-engine.jar
block java 2 >module-info.java
{ echo 'package drop;' && block java 1; } >drop/Drop.java
block sh 2 >try.sh
passed 'module path' "$(sh -eu try.sh)"

project gradle
mkdir -p src/main/java
block groovy 1 >build.gradle
: >settings.gradle
block java 1 >src/main/java/Drop.java
gradle -q -Dorg.gradle.daemon=false -Dmaven.repo.local="$repository" classes >build.log 2>&1 || { cat build.log >&2; exit 1; }
passed 'Gradle' "$(java -cp "$engine:build/classes/java/main" Drop)"

if command -v mvn >/dev/null; then
    project maven
    mkdir -p src/main/java
    block xml 1 >pom.xml
    block java 1 >src/main/java/Drop.java
    mvn -q -B -Dmaven.repo.local="$repository" compile >build.log 2>&1 || { cat build.log >&2; exit 1; }
    passed 'Maven' "$(java -cp "$engine:target/classes" Drop)"
else
    echo 'Maven: not tried, for there is none here'
fi
