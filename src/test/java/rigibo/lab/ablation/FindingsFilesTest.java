package rigibo.lab.ablation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

import javax.xml.parsers.DocumentBuilderFactory;

class FindingsFilesTest {

    /** A letter is no wider than this share of its height, in sans-serif. */
    private static final double LETTER = 0.6;

    /** Where a text is: from left to right, on its baseline. */
    private record Place(String words, double left, double right, double y, double size) {

        boolean overlaps(Place other) {
            return left < other.right
                    && other.left < right
                    && Math.abs(y - other.y) < Math.min(size, other.size);
        }
    }

    @Test
    void tableHasALineForEachComparison() {
        List<String> lines = FindingsCsv.lines(Fake.findings());
        assertThat(lines).hasSize(1 + 1 + 4 + 1);
        assertThat(lines).allMatch(line -> line.split(",", -1).length == 14);
        assertThat(lines.get(1)).startsWith("undeclared,flyers,,,5000.0,5010.0,ratio,1.002,");
    }

    @Test
    void figureIsWellFormedAndItsWordsKeepApart() throws Exception {
        List<Place> places = places(new EffectsFigure(Fake.findings()).text());
        assertThat(places).hasSizeGreaterThan(20);
        for (Place one : places) {
            assertThat(one.left()).as(one.words()).isNotNegative();
            assertThat(one.right()).as(one.words()).isLessThanOrEqualTo(EffectsFigure.WIDTH);
            assertThat(places)
                    .filteredOn(other -> other != one && other.overlaps(one))
                    .as("over '%s'", one.words())
                    .isEmpty();
        }
    }

    private static List<Place> places(String svg) throws Exception {
        Document document =
                DocumentBuilderFactory.newInstance()
                        .newDocumentBuilder()
                        .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8)));
        NodeList texts = document.getElementsByTagName("text");
        List<Place> places = new ArrayList<>();
        for (int i = 0; i < texts.getLength(); i++) {
            places.add(place((Element) texts.item(i)));
        }
        return places;
    }

    private static Place place(Element text) {
        String words = text.getTextContent();
        double size = Double.parseDouble(text.getAttribute("font-size"));
        double width = LETTER * size * words.length();
        double x = Double.parseDouble(text.getAttribute("x"));
        double left =
                switch (text.getAttribute("text-anchor")) {
                    case "end" -> x - width;
                    case "middle" -> x - width / 2;
                    default -> x;
                };
        double y = Double.parseDouble(text.getAttribute("y"));
        return new Place(words, left, left + width, y, size);
    }
}
