package rigibo.frontend.gallery;

import java.util.function.Supplier;

/**
 * A registered exhibit before an instance is made.
 *
 * @param type its class
 * @param make makes an instance
 */
public record Found(Class<? extends Exhibit> type, Supplier<? extends Exhibit> make) {

    private static final String SOURCES = "src/examples/java/";

    /** Name of its class in the form of the command line, such as {@code card-house}. */
    public String name() {
        return Exhibit.name(type);
    }

    /** The last word of its package: exhibits of one package are shown together. */
    public String section() {
        String whole = type.getPackageName();
        return whole.substring(whole.lastIndexOf('.') + 1);
    }

    /** Its source file, as a path in the checkout. */
    public String source() {
        return SOURCES + type.getName().replace('.', '/') + ".java";
    }
}
