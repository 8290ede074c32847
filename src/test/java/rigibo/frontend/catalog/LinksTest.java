package rigibo.frontend.catalog;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.Link;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.util.stream.Stream;

/** Links, opened as the page opens them. */
class LinksTest {

    private final RecordingDirector director = new RecordingDirector();

    static Stream<String> names() {
        return Stream.concat(Catalog.entries().stream(), Catalog.exhibits().stream())
                .map(SceneEntry::name);
    }

    private Scene open(String link) {
        return Catalog.linked(link).orElseThrow().apply(director);
    }

    @ParameterizedTest
    @MethodSource("names")
    void everySceneSaysWhereItIs(String name) {
        Scene scene = open(name);
        assertThat(scene.link()).isEqualTo(Link.to(name));
        scene.closed();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "moving-lift?accuracy=exact",
                "friction?accuracy=draft&ghost=on",
                "friction?ramp=40&speed=2.5&mass=7",
                "pendulum?accuracy=fine&what=2&amplitude=90&length=1.2&ratio=0",
                "laboratory?experiment=stack&left=fine&right=exact&graph=energy",
                "laboratory?experiment=billiard&left=draft&left-substeps=12&left-iterations=3"
                        + "&left-tolerance=-6&left-impacts=32&right=game&graph=expert",
                "two-storeys?pace=half",
                "crossing?pace=quarter",
                "editor?grid=off"
            })
    void whatIsChosenIsThereAgain(String link) {
        Scene scene = open(link);
        scene.step();
        assertThat(scene.link().text()).isEqualTo(link);
        assertThat(director.said).isEmpty();
        scene.closed();
    }

    /** The rest of a link holds. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "ramp=61",
                "ramp=-1",
                "ramp=steep",
                "ramp=",
                "ghost=1",
                "accuracy=perfect",
                "nothing=1",
                "&",
                "<b>"
            })
    void whatMeansNothingIsToldAndLeftOut(String choice) {
        Scene scene = open("friction?mass=7&" + choice);
        assertThat(director.said).containsExactly(director.words().of("link.partly"));
        assertThat(scene.link().choices()).containsEntry("mass", "7").containsEntry("ramp", "0");
        scene.closed();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "laboratory?experiment=falling",
                "laboratory?left=perfect",
                "laboratory?right-substeps=65",
                "laboratory?right-tolerance=fine",
                "laboratory?graph=beauty",
                "two-storeys?pace=double",
                "two-storeys?accuracy=exact",
                "editor?grid=7",
                "editor?accuracy=fine",
                "gallery?nothing=1"
            })
    void whatASceneDoesNotHaveIsToldAndTheSceneIsAsItBegins(String link) {
        Scene scene = open(link);
        assertThat(director.said).containsExactly(director.words().of("link.partly"));
        assertThat(scene.link()).isEqualTo(Link.to(Link.of(link).scene()));
        scene.closed();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "nowhere", "nowhere?accuracy=fine", "friction/", "FRICTION"})
    void noSceneIsFoundWhereThereIsNone(String link) {
        assertThat(Catalog.linked(link)).isEmpty();
    }
}
