package rigibo.frontend.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Map;

class LinkTest {

    @ParameterizedTest
    @ValueSource(
            strings = {"", "flood", "flood?accuracy=fine", "wheel?torque=-15&grip=0.65&hoop=on"})
    void readsWhatItWrites(String text) {
        assertThat(Link.of(text).text()).isEqualTo(text);
    }

    @Test
    void saysTheSceneAndWhatIsChosen() {
        Link link = Link.of("crate?size=0.7&accuracy=draft");
        assertThat(link.scene()).isEqualTo("crate");
        assertThat(link.choices()).isEqualTo(Map.of("size", "0.7", "accuracy", "draft"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"<script>", "../secret", "Flood", "a b", "?accuracy=fine", "flood#wheel"})
    void whatIsNoNameLeadsToTheMenu(String text) {
        assertThat(Link.of(text)).isEqualTo(Link.MENU);
    }

    @Test
    void whatIsTooLongLeadsToTheMenu() {
        String longest = "flood?" + "a=1&".repeat(98) + "b=";
        assertThat(longest).hasSize(Link.LONGEST);
        assertThat(Link.of(longest).scene()).isEqualTo("flood");
        assertThat(Link.of(longest + "1")).isEqualTo(Link.MENU);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "accuracy",
                "=fine",
                "a=",
                "a=<b>",
                "a=1e9",
                "a=NaN",
                "a=--1",
                "a=1.",
                "a=12345678",
                "a=1=2",
                "%00=1"
            })
    void aBrokenChoiceIsOneThatNobodyHas(String choice) {
        assertThat(Link.of("flood?" + choice).choices()).isEqualTo(Map.of("", ""));
        assertThat(Link.of("flood?size=0.2&" + choice).choices()).containsEntry("size", "0.2");
    }
}
