package rigibo.frontend.gallery;

import java.util.List;
import java.util.ServiceLoader;

/** The exhibits that are on the class path. */
final class Registered {

    private Registered() {}

    /** In the order of registration. */
    static List<Found> all() {
        return ServiceLoader.load(Exhibit.class).stream()
                .map(provider -> new Found(provider.type(), provider))
                .toList();
    }
}
