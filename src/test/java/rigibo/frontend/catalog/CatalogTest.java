package rigibo.frontend.catalog;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.SceneEntry;

import java.util.stream.Stream;

class CatalogTest {

    /** The command line opens a scene by its name, and a tour keeps its picture under it. */
    @Test
    void noTwoScenesShareAName() {
        assertThat(Stream.concat(Catalog.entries().stream(), Catalog.exhibits().stream()))
                .extracting(SceneEntry::name)
                .hasSizeGreaterThan(100)
                .doesNotHaveDuplicates();
    }
}
