// Shows what the program prints, for whoever reads the page.
const lines = document.getElementById('lines');
console.log = (...words) => {
    lines.textContent += words.join(' ') + '\n';
};

TeaVM.wasmGC.load('bits.wasm')
    .then(program => program.exports.main([]))
    .catch(problem => console.log('This browser cannot run it: ' + problem));
