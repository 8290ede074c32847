// Shows what a program prints, for whoever reads the page. The page's link names it: lines.html?bits
const lines = document.getElementById('lines');
console.log = console.info = (...words) => {
    lines.textContent += words.join(' ') + '\n';
};

const name = location.search.substring(1);

const script = file => new Promise((loaded, failed) => {
    const element = document.createElement('script');
    element.src = file;
    element.onload = loaded;
    element.onerror = () => failed(file + ' is missing');
    document.head.append(element);
});

const text = file => fetch(file).then(answer => answer.ok ? answer.text() : '');

const run = async () => {
    window.rigiboFiles = await text(name + '.txt');
    if (name.endsWith('-script')) {
        await script(name + '.js');
        // It goes on when it has begun, and calls back when it has ended.
        await new Promise(ended => main([], ended));
    } else {
        await script(name + '-functions.js');
        (await TeaVM.wasmGC.load(name + '.wasm')).exports.main([]);
    }
};

run()
    .catch(problem => console.log('This browser cannot run it: ' + problem))
    // To whoever serves the page and cannot look at it.
    .then(() => fetch('said', { method: 'POST', body: lines.textContent }));
