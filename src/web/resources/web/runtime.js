// What stands in TeaVM's runtime in place of the parts that make functions of texts, each by its first line.

function getGlobalName(name) {
    return name.split('.').reduce((place, part) => place[part], globalThis);
}

function setGlobalName(name, value) {
    globalThis[name] = value;
}

function defineFunction(fn, vararg) {
    const named = fn.length - 1;
    return (...given) => {
        try {
            return vararg ? fn(...given.slice(0, named), given.slice(named)) : fn(...given);
        } catch (e) {
            rethrowJavaAsJs(e);
        }
    };
}

function renameConstructor(name, c) {
    const named = function(marker, javaObject) {
        return c.call(this, marker, javaObject);
    };
    return Object.defineProperty(named, 'name', { value: name });
}

defineMethod(cls, name, fn, vararg) {
    const named = fn.length - 2;
    cls.prototype[name] = function(...given) {
        try {
            return vararg ? fn(this, ...given.slice(0, named), given.slice(named)) : fn(this, ...given);
        } catch (e) {
            rethrowJavaAsJs(e);
        }
    };
}

for (let i = 0; i < 32; ++i) {
    const jso = imports.teavmJso;
    const calling = call => {
        try {
            return call();
        } catch (e) {
            rethrowJsAsJava(e);
        }
    };
    jso['createFunction' + i] = (...words) => {
        const text = words.pop();
        const made = rigiboFunctions[words + '=>' + text];
        if (made === undefined) {
            throw new Error('no function was built of the text ' + text);
        }
        return made.bind(null, wrapCallFromJavaToJs);
    };
    jso['bindFunction' + i] = (fn, ...bound) => fn.bind(null, ...bound);
    jso['callFunction' + i] = (fn, ...given) => calling(() => fn(...given));
    jso['callMethod' + i] = (instance, method, ...given) => calling(() =>
        instance !== null ? instance[method](...given) : getGlobalName(method)(...given));
    jso['construct' + i] = (constructor, ...given) => calling(() => new constructor(...given));
    jso['arrayOf' + i] = (...values) => values;
}
