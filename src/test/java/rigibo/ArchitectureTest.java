package rigibo;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaMethodCall;
import com.tngtech.archunit.core.importer.ClassFileImporter;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.examples.FallingCrate;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The arrows between the rooms run one way. */
class ArchitectureTest {

    /**
     * The classes of the directory or archive that holds {@code Main}, without tests and examples.
     */
    private static final JavaClasses CLASSES = classesBeside(Main.class);

    private static final JavaClasses EXAMPLES = classesBeside(FallingCrate.class);

    private static final String BACKEND = "rigibo.backend";
    private static final String FRONTEND = "rigibo.frontend";
    private static final String PUZZLE = FRONTEND + ".puzzle";
    private static final String COLLISION = BACKEND + ".collision";

    /** The only room that knows threads: where there are none, nothing else is missing. */
    private static final String TEAM = BACKEND + ".team";

    /** The engine's public rooms: only these may be used from outside it. */
    private static final String[] PUBLIC_FACE = {
        BACKEND, BACKEND + ".geometry", BACKEND + ".setup", BACKEND + ".effect"
    };

    /** Mathematics whose last bit a JVM or a browser may choose, or that a browser lacks. */
    private static final Set<String> LOOSE_MATHEMATICS =
            Set.of(
                    "sin",
                    "cos",
                    "tan",
                    "asin",
                    "acos",
                    "atan",
                    "atan2",
                    "sinh",
                    "cosh",
                    "tanh",
                    "exp",
                    "expm1",
                    "log",
                    "log10",
                    "log1p",
                    "pow",
                    "cbrt",
                    "hypot",
                    "random",
                    "toRadians",
                    "toDegrees",
                    "fma",
                    "IEEEremainder");

    /** Rooms whose classes produce or judge results that must be the same everywhere. */
    private static final String[] SAME_BITS_EVERYWHERE = {
        BACKEND + "..",
        PUZZLE + ".level..",
        PUZZLE + ".rules..",
        PUZZLE + ".generate..",
        FRONTEND + ".demo..",
        "rigibo.fuzz.program.."
    };

    private static final Set<String> CLOCKS = Set.of("nanoTime", "currentTimeMillis");

    /** A room and the rooms it may use, besides itself. */
    private record Room(String name, String... uses) {
        @Override
        public String toString() {
            return name;
        }
    }

    static Stream<Room> backendRooms() {
        String[][] fromLeftToRight = {
            {"geometry", "team"},
            {"setup"},
            {"effect"},
            {"storage"},
            {"algebra", "force", "broadphase", "collision"},
            {"impact"},
            {"flight", "contact", "rest", "sense"},
            {"step"},
            {"saved"}
        };
        return leftToRight(BACKEND, fromLeftToRight);
    }

    /** Rooms within the puzzle; what they use outside it is asked of the whole. */
    static Stream<Room> puzzleRooms() {
        String[][] fromLeftToRight = {
            {"level"},
            {"picture", "rules"},
            {"check"},
            {"generate"},
            {"replay"},
            {"session", "record"},
            {"show", "endless"},
            {"hud"}
        };
        return leftToRight(PUZZLE, fromLeftToRight);
    }

    /** Rooms within the narrow phase. */
    static Stream<Room> collisionRooms() {
        return leftToRight(COLLISION, new String[][] {{"manifold"}, {"distance"}});
    }

    /** Rooms that see those to their left, and the room they are in, which sees them all. */
    private static Stream<Room> leftToRight(String whole, String[][] fromLeftToRight) {
        Stream.Builder<Room> rooms = Stream.builder();
        String[] left = {};
        for (String[] siblings : fromLeftToRight) {
            for (String name : siblings) {
                rooms.add(new Room(whole + "." + name, left));
            }
            String[] names =
                    Arrays.stream(siblings).map(name -> whole + "." + name).toArray(String[]::new);
            left = plus(left, names);
        }
        return rooms.add(new Room(whole, left)).build();
    }

    static Stream<Room> otherRooms() {
        String scene = FRONTEND + ".scene";
        String[] withScene = plus(PUBLIC_FACE, scene);
        // How files are read, whatever they are about.
        String document = FRONTEND + ".document";
        String save = FRONTEND + ".save";
        // Makes levels and plays what it makes.
        String editor = FRONTEND + ".editor";
        String[] plain = {
            FRONTEND + ".menu", FRONTEND + ".demo", FRONTEND + ".laboratory", FRONTEND + ".gallery"
        };
        String[] scenes = plus(plain, PUZZLE);
        Stream<Room> sceneRooms = Arrays.stream(plain).map(name -> new Room(name, withScene));
        String draw = FRONTEND + ".draw";
        String sound = FRONTEND + ".sound";
        return Stream.concat(
                sceneRooms,
                Stream.of(
                        new Room(scene, PUBLIC_FACE),
                        new Room(draw, withScene),
                        new Room(sound, withScene),
                        new Room(document),
                        new Room(save, scene, document),
                        new Room(PUZZLE, plus(withScene, save, document)),
                        new Room(FRONTEND + ".display", plus(withScene, draw, sound)),
                        new Room(editor, plus(withScene, PUZZLE, save, document)),
                        new Room(FRONTEND + ".catalog", plus(plus(withScene, scenes), editor)),
                        new Room("rigibo.film", scene, FRONTEND + ".display"),
                        // Reads what the game reads, as the game does.
                        new Room(
                                "rigibo.fuzz", plus(withScene, PUZZLE, editor, FRONTEND + ".save")),
                        new Room("rigibo.lab", PUBLIC_FACE)));
    }

    private static String[] plus(String[] some, String... more) {
        return Stream.concat(Arrays.stream(some), Arrays.stream(more)).toArray(String[]::new);
    }

    @ParameterizedTest
    @MethodSource({"backendRooms", "otherRooms"})
    void roomUsesOnlyRoomsToItsLeft(Room room) {
        check(room, "rigibo", ArchitectureTest::roomOf);
    }

    @ParameterizedTest
    @MethodSource("puzzleRooms")
    void roomOfThePuzzleUsesOnlyRoomsToItsLeft(Room room) {
        check(room, PUZZLE, JavaClass::getPackageName);
    }

    @ParameterizedTest
    @MethodSource("collisionRooms")
    void roomOfTheNarrowPhaseUsesOnlyRoomsToItsLeft(Room room) {
        check(room, COLLISION, JavaClass::getPackageName);
    }

    /** Only dependencies within the whole program are checked. */
    private static void check(Room room, String whole, Function<JavaClass, String> roomOf) {
        Set<String> allowed = Arrays.stream(room.uses()).collect(Collectors.toSet());
        classes()
                .that(areIn(room.name(), roomOf))
                .should()
                .onlyDependOnClassesThat(
                        DescribedPredicate.describe(
                                "are in " + room + " or to its left " + allowed,
                                other ->
                                        !other.getPackageName().startsWith(whole)
                                                || roomOf.apply(other).equals(room.name())
                                                || allowed.contains(roomOf.apply(other))))
                .allowEmptyShould(true)
                .check(CLASSES);
    }

    private static JavaClasses classesBeside(Class<?> one) {
        return new ClassFileImporter()
                .importUrl(one.getProtectionDomain().getCodeSource().getLocation());
    }

    @Test
    void everyInnerPackageIsOfARoom() {
        Set<String> rooms =
                Stream.concat(puzzleRooms(), collisionRooms())
                        .map(Room::name)
                        .collect(Collectors.toSet());
        assertThat(CLASSES)
                .extracting(JavaClass::getPackageName)
                .filteredOn(name -> name.startsWith(PUZZLE) || name.startsWith(COLLISION))
                .isNotEmpty()
                .allMatch(rooms::contains);
    }

    @Test
    void everyPackageIsOfARoom() {
        Set<String> rooms =
                Stream.concat(backendRooms(), otherRooms())
                        .map(Room::name)
                        .collect(Collectors.toSet());
        assertThat(CLASSES)
                .isNotEmpty()
                .allSatisfy(
                        type ->
                                assertThat(
                                                roomOf(type).equals("rigibo")
                                                        || rooms.contains(roomOf(type)))
                                        .as("%s is in none of the rooms %s", type.getName(), rooms)
                                        .isTrue());
    }

    /** The room is the second word after {@code rigibo}, or the first where there is none. */
    private static String roomOf(JavaClass type) {
        String[] words = type.getBaseComponentType().getPackageName().split("\\.");
        boolean hasInnerRooms =
                words.length > 2 && (words[1].equals("backend") || words[1].equals("frontend"));
        int length = Math.min(words.length, hasInnerRooms ? 3 : 2);
        return String.join(".", Arrays.copyOf(words, length));
    }

    private static DescribedPredicate<JavaClass> areIn(
            String room, Function<JavaClass, String> roomOf) {
        return DescribedPredicate.describe(
                "are in " + room, type -> roomOf.apply(type).equals(room));
    }

    @Test
    void packagesHaveNoCycles() {
        slices().matching("rigibo.(**)").should().beFreeOfCycles().check(CLASSES);
    }

    @Test
    void engineStandsOnItselfAndTheCoreOfJavaAlone() {
        classes()
                .that()
                .resideInAPackage("rigibo.backend..")
                .and()
                .resideOutsideOfPackage(TEAM)
                .should()
                .onlyDependOnClassesThat(
                        resideInAPackage("rigibo.backend..")
                                .or(resideInAPackage("java.lang"))
                                .or(resideInAPackage("java.lang.invoke"))
                                .or(resideInAPackage("java.lang.runtime"))
                                .or(resideInAPackage("java.util"))
                                .or(resideInAPackage("java.util.function"))
                                .or(resideInAPackage("java.util.stream"))
                                .or(isPrimitive()))
                .check(CLASSES);
    }

    private static DescribedPredicate<JavaClass> isPrimitive() {
        return DescribedPredicate.describe(
                "are primitive", type -> type.getBaseComponentType().isPrimitive());
    }

    @Test
    void engineKnowsNoChanceAndNoTime() {
        List<String> names =
                List.of(
                        "java.util.Random",
                        "java.util.SplittableRandom",
                        "java.util.UUID",
                        "java.util.Date",
                        "java.util.Timer",
                        "java.util.Calendar",
                        "java.lang.Thread",
                        "java.lang.Process");
        noClasses()
                .that()
                .resideInAPackage("rigibo.backend..")
                .and()
                .resideOutsideOfPackage(TEAM)
                .should()
                .dependOnClassesThat(
                        DescribedPredicate.describe(
                                "are chance or time", type -> names.contains(type.getName())))
                .orShould()
                .callMethodWhere(
                        DescribedPredicate.<JavaMethodCall>describe(
                                "asks a clock",
                                call ->
                                        call.getTargetOwner().getName().equals("java.lang.System")
                                                && CLOCKS.contains(call.getName())))
                .check(CLASSES);
    }

    @Test
    void engineLevelsAndDemosComputeTheSameBitsEverywhere() {
        noClasses()
                .that()
                .resideInAnyPackage(SAME_BITS_EVERYWHERE)
                .should()
                .callMethodWhere(isLooseMathematics())
                .check(CLASSES);
    }

    /** They run on the page, too. The tutorial only prints a logarithm. */
    @Test
    void exhibitsComputeTheSameBitsEverywhere() {
        noClasses()
                .that()
                .resideOutsideOfPackage("rigibo.tutorial..")
                .should()
                .callMethodWhere(isLooseMathematics())
                .check(EXAMPLES);
    }

    private static DescribedPredicate<JavaMethodCall> isLooseMathematics() {
        return DescribedPredicate.describe(
                "calls mathematics whose last bit is free",
                call ->
                        call.getTargetOwner().getName().endsWith("Math")
                                && LOOSE_MATHEMATICS.contains(call.getName()));
    }

    @Test
    void onlyDrawSoundAndDisplaySeeTheLibraryOfWindows() {
        noClasses()
                .that()
                .resideOutsideOfPackages(
                        FRONTEND + ".draw..", FRONTEND + ".sound..", FRONTEND + ".display..")
                .should()
                .dependOnClassesThat()
                .resideInAPackage("org.lwjgl..")
                .check(CLASSES);
    }

    @Test
    void onlyPlotsAndFilmsUseAwt() {
        noClasses()
                .that()
                .resideOutsideOfPackages("rigibo.lab.plot..", "rigibo.film..")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(
                        "java.awt..", "javax.imageio..", "javax.swing..", "org.knowm.xchart..")
                .check(CLASSES);
    }

    @Test
    void everyPackageSaysWhatItIsFor() throws IOException {
        Path sources = Path.of(System.getProperty("rigibo.home", ""), "src", "main", "java");
        try (Stream<Path> files = Files.walk(sources)) {
            List<Path> packages =
                    files.filter(file -> file.toString().endsWith(".java"))
                            .map(Path::getParent)
                            .distinct()
                            .collect(Collectors.toList());
            assertThat(packages).isNotEmpty();
            for (Path directory : packages) {
                Path words = directory.resolve("package-info.java");
                assertThat(words).exists();
                assertThat(Files.readString(words)).as("%s", words).contains("/**");
            }
        }
    }
}
