package org.teavm.jso.impl.wasmgc;

import org.teavm.backend.javascript.rendering.AstWriter;
import org.teavm.jso.impl.JSBodyAstEmitter;
import org.teavm.jso.impl.JSBodyBloatedEmitter;
import org.teavm.jso.impl.JSBodyEmitter;
import org.teavm.jso.impl.JSBodyRepository;
import org.teavm.jso.impl.JsBodyImportInfo;

import tools.jackson.databind.node.JsonNodeFactory;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The functions that a program would have the browser make of texts. They are printed as {@link
 * WasmGCJsoCommonGenerator} prints them, since the program asks for them by those texts.
 */
public final class FunctionTexts {

    /** Name in those texts of the function through which calls of the page's functions go. */
    private static final String CALLER = "wrapCallFromJavaToJs";

    private static final String THIS = "__this__";

    private FunctionTexts() {}

    /** All functions as a JavaScript object, with their parameters and texts as keys. */
    public static String table(JSBodyRepository repository) {
        return repository.emitters.values().stream()
                .map(each -> entry(each, repository.inlineMethods.contains(each.method())))
                .distinct()
                .sorted()
                .collect(Collectors.joining(",\n", "{\n", "\n}"));
    }

    private static String entry(JSBodyEmitter emitter, boolean isExpression) {
        String parameters = String.join(",", parameters(emitter));
        String text = text(emitter, isExpression);
        String key = JsonNodeFactory.instance.stringNode(parameters + "=>" + text).toString();
        String all = parameters.isEmpty() ? CALLER : CALLER + "," + parameters;
        return key + ": function(" + all + ") {" + text + "\n}";
    }

    private static List<String> parameters(JSBodyEmitter emitter) {
        List<String> names = new ArrayList<>();
        for (JsBodyImportInfo imported : emitter.imports()) {
            names.add(imported.alias);
        }
        if (!emitter.isStatic()) {
            names.add(THIS);
        }
        names.addAll(List.of(emitter.parameterNames()));
        return names;
    }

    private static String text(JSBodyEmitter emitter, boolean isExpression) {
        if (emitter instanceof JSBodyBloatedEmitter whole) {
            return whole.script;
        }
        WasmGCJSBodyWriter writer = new WasmGCJSBodyWriter();
        AstWriter printer = new AstWriter(writer, name -> (to, precedence) -> to.append(name));
        if (!emitter.isStatic()) {
            printer.declareNameEmitter("this", (to, precedence) -> to.append(THIS));
        }
        printer.print(((JSBodyAstEmitter) emitter).ast);
        return isExpression ? "return " + writer.sb + ";" : writer.sb.toString();
    }
}
