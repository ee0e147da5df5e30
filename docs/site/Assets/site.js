'use strict';

// Runs in the head, so that the first frame already has the theme that was chosen last.
(() => {
  const page = document.documentElement;
  const stored = {
    get theme() { try { return localStorage.getItem('theme'); } catch { return null; } },
    set theme(value) { try { localStorage.setItem('theme', value); } catch { /* not kept where storage is off */ } },
  };
  if (stored.theme) page.dataset.theme = stored.theme;

  function switchTheme() {
    const isDark = page.dataset.theme ? page.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
    page.dataset.theme = stored.theme = isDark ? 'light' : 'dark';
  }

  function openMenu(button, pages) {
    const isOpen = pages.classList.toggle('open');
    button.setAttribute('aria-expanded', isOpen);
  }

  // Code

  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
    } catch { // no clipboard on pages that are opened as files in some browsers
      const area = document.body.appendChild(document.createElement('textarea'));
      area.value = text;
      area.select();
      document.execCommand('copy');
      area.remove();
    }
  }

  function addCopyButton(pre) {
    const frame = document.createElement('div');
    const button = document.createElement('button');
    frame.className = 'code';
    button.type = 'button';
    button.textContent = 'Copy';
    button.addEventListener('click', async () => {
      await copy(pre.textContent.trimEnd());
      button.textContent = 'Copied';
      setTimeout(() => button.textContent = 'Copy', 1500);
    });
    pre.replaceWith(frame);
    frame.append(pre, button);
  }

  // Contents: the section that is being read is marked.

  function followSections(contents) {
    const links = new Map([...contents.querySelectorAll('a')].map(link => [decodeURIComponent(link.hash.slice(1)), link]));
    const headings = [...document.querySelectorAll('article h2, article h3')].filter(heading => links.has(heading.id));
    let here;
    const mark = () => {
      const edge = innerHeight / 4;
      const heading = headings.findLast(next => next.getBoundingClientRect().top < edge) ?? headings[0];
      const link = links.get(heading?.id);
      if (link === here) return;
      here?.classList.remove('here');
      link?.classList.add('here');
      here = link;
    };
    addEventListener('scroll', () => requestAnimationFrame(mark), { passive: true });
    mark();
  }

  // Search: every word must occur in the section or its title; titles count more than headings, headings more than text.

  const escape = text => text.replace(/[&<>"]/g, c => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);
  const pattern = words => new RegExp(words.map(word => word.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')).join('|'), 'gi');

  function score(text, word, weight) {
    const at = text.toLowerCase().indexOf(word);
    if (at < 0) return 0;
    return at === 0 || /[^\p{L}\p{N}]/u.test(text[at - 1]) ? 2 * weight : weight;
  }

  function find(query) {
    const words = query.toLowerCase().split(/\s+/).filter(word => word);
    const phrase = words.join(' ');
    const found = [];
    if (words.length === 0) return found;
    for (const [title, address, sections] of searchIndex) {
      for (const [id, heading, text] of sections) {
        let sum = id ? 0 : 1;
        for (const word of words) {
          const points = score(title, word, 10) + score(heading, word, 20) + score(text, word, 1);
          if (points === 0) { sum = -1; break; }
          sum += points;
        }
        if (sum > 0 && words.length > 1) sum += score(title, phrase, 10) + score(heading, phrase, 20) + score(text, phrase, 5);
        if (sum > 0) found.push({ title, heading, text, sum, address: address + (id ? '#' + id : '') });
      }
    }
    return found.sort((a, b) => b.sum - a.sum).slice(0, 20);
  }

  function render(query) {
    const words = pattern(query.split(/\s+/).filter(word => word));
    const highlight = text => {
      let [html, end] = ['', 0];
      for (const match of text.matchAll(words)) {
        html += escape(text.slice(end, match.index)) + '<mark>' + escape(match[0]) + '</mark>';
        end = match.index + match[0].length;
      }
      return html + escape(text.slice(end));
    };
    return find(query).map(({ title, heading, text, address }) => {
      const phrase = text.toLowerCase().indexOf(query.toLowerCase());
      const at = Math.max(0, (phrase < 0 ? text.search(words) : phrase) - 60);
      const start = at && text.indexOf(' ', at) + 1;
      const excerpt = (start ? '... ' : '') + text.slice(start, start + 170) + (start + 170 < text.length ? ' ...' : '');
      const name = heading === title ? highlight(title) : highlight(title) + ' &rsaquo; ' + highlight(heading);
      return `<a href="${page.dataset.root}${address}"><b>${name}</b><small>${highlight(excerpt)}</small></a>`;
    }).join('') || '<p>No page has all of these words.</p>';
  }

  function startSearch(input, results) {
    let loading;
    const load = () => loading ??= new Promise((done, failed) => {
      const script = document.createElement('script');
      script.src = page.dataset.root + 'assets/search.js';
      script.onload = done;
      script.onerror = failed;
      document.head.append(script);
    });
    const choose = step => {
      const links = [...results.querySelectorAll('a')];
      const at = links.findIndex(link => link.classList.contains('chosen'));
      links[at]?.classList.remove('chosen');
      const next = links[(at + step + links.length) % links.length];
      next?.classList.add('chosen');
      next?.scrollIntoView({ block: 'nearest' });
    };
    const show = async () => {
      const query = input.value.trim();
      results.hidden = query.length < 2;
      if (results.hidden) return;
      await load();
      if (input.value.trim() !== query) return;
      results.innerHTML = render(query);
      results.querySelector('a')?.classList.add('chosen');
    };
    input.addEventListener('focus', load);
    input.addEventListener('input', show);
    input.addEventListener('keydown', event => {
      if (event.key === 'ArrowDown') choose(1);
      else if (event.key === 'ArrowUp') choose(-1);
      else if (event.key === 'Enter') results.querySelector('.chosen')?.click();
      else if (event.key === 'Escape') { input.value = ''; results.hidden = true; input.blur(); }
      else return;
      event.preventDefault();
    });
    results.addEventListener('click', () => results.hidden = true);
    addEventListener('click', event => { if (!event.target.closest('.search')) results.hidden = true; });
    addEventListener('keydown', event => {
      if (event.key !== '/' || event.target.closest('input, textarea') || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      input.focus();
    });
    const asked = new URLSearchParams(location.search).get('search');
    if (asked) { input.value = asked; show(); }
  }

  addEventListener('DOMContentLoaded', () => {
    const one = selector => document.querySelector(selector);
    one('.theme').addEventListener('click', switchTheme);
    one('.menu').addEventListener('click', event => openMenu(event.currentTarget, one('.pages')));
    const [pages, current] = [one('.pages'), one('.pages [aria-current]')];
    if (current && current.offsetTop > pages.clientHeight - 80) pages.scrollTop = current.offsetTop - pages.clientHeight / 2;
    document.querySelectorAll('article pre').forEach(addCopyButton);
    const contents = one('.contents');
    if (contents) {
      if (matchMedia('(max-width: 1180px)').matches) contents.open = false;
      followSections(contents);
    }
    startSearch(one('.search input'), one('.results'));
  });
})();
