package rigibo.frontend.gallery;

import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;

/** The exhibits that were registered when the page was built. */
final class Registered {

    private static final List<Found> ALL = new ArrayList<>();

    private Registered() {}

    /** In the order of registration. */
    static List<Found> all() {
        if (ALL.isEmpty()) {
            for (Exhibit exhibit : ServiceLoader.load(Exhibit.class)) {
                Class<? extends Exhibit> type = exhibit.getClass();
                ALL.add(new Found(type, () -> anew(type)));
            }
        }
        return ALL;
    }

    /** A new exhibit each time, since exhibits hold their bodies. */
    private static Exhibit anew(Class<? extends Exhibit> type) {
        for (Exhibit exhibit : ServiceLoader.load(Exhibit.class)) {
            if (exhibit.getClass() == type) {
                return exhibit;
            }
        }
        throw new IllegalStateException(type + " is gone");
    }
}
