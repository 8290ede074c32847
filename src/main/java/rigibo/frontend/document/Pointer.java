package rigibo.frontend.document;

import java.util.Arrays;
import java.util.List;

/** JSON pointers as RFC 6901 writes them. */
final class Pointer {

    private Pointer() {}

    /** The pointer of a member or an element of the value at a pointer. */
    static String member(String pointer, String name) {
        return pointer + "/" + name.replace("~", "~0").replace("/", "~1");
    }

    /** The names and indices on the way. */
    static List<String> steps(String pointer) {
        return Arrays.stream(pointer.split("/", -1))
                .skip(1)
                .map(step -> step.replace("~1", "/").replace("~0", "~"))
                .toList();
    }

    /** A step as an index, or -1 where it is none. */
    static int index(String step) {
        return step.matches("\\d{1,9}") ? Integer.parseInt(step) : -1;
    }
}
