using System.Diagnostics;
using Engraver.Core;
using Engraver.Core.Diagnostics;
using Engraver.Fonts.Finding;
using Engraver.Workbench.Lettering;

namespace Engraver.Workbench.LetteredDrawings;

/// <summary>Collects what lettering reports: each font, character, code and form once, with the first place in the file and the number of texts.</summary>
internal sealed class LetteringFindings
{
    private const int ShownLength = 40;

    private readonly List<Diagnostic> _lost = [];
    private readonly List<Diagnostic> _faults = [];
    private readonly Dictionary<LayoutNoteKind, Noted> _notes = [];
    private (SourceRef First, int Count)? _tilted;

    public IReadOnlyList<Diagnostic> Faults => _faults;

    public void Add(SourceRef source, IReadOnlyList<LayoutNote> notes)
    {
        foreach (var of in notes.GroupBy(note => note.Kind))
        {
            if (!_notes.TryGetValue(of.Key, out var noted)) _notes[of.Key] = noted = new Noted(source);
            noted.Texts++;
            foreach (var note in of) noted.Add(note.Detail);
        }
    }

    public void AddNoSize(SourceRef source, string content) => _lost.Add(LetteringRules.NoSize.At(source, Shown(content)));

    public void AddOutOfRange(SourceRef source, string content) => _lost.Add(LetteringRules.OutOfRange.At(source, Shown(content)));

    public void AddDamaged(SourceRef source, string content, int group) => _lost.Add(LetteringRules.Damaged.At(source, Shown(content), FactText.Of(group)));

    public void AddNotUnited(SourceRef source, string content) => _lost.Add(LetteringRules.NotUnited.At(source, Shown(content)));

    public void AddTilted(SourceRef source) => _tilted = (_tilted?.First ?? source, (_tilted?.Count ?? 0) + 1);

    public void AddMisplaced(SourceRef source, string content, Misplacement found) => _faults.Add(VerificationRules.LettersMisplaced.At(
        source, Shown(content), FactText.Of(found.Distance), NumberText.Rounded(found.At.X, 4), NumberText.Rounded(found.At.Y, 4)));

    /// <summary>All findings: lost texts, fonts, then what the layouts noted.</summary>
    public IReadOnlyList<Diagnostic> Of(LetterFonts fonts)
    {
        var all = new List<Diagnostic>(_lost);
        all.AddRange(fonts.Faults.Select(fault => LetteringRules.SubstitutesUnreadable.At(default, FactText.Of(fault.Line), fault.Path)));
        all.AddRange(fonts.Used.Where(font => font.Match != FontMatch.Exact && font.Request is not { File: "", Family: "" }).Select(Substituted));
        all.AddRange(_notes.OrderBy(pair => pair.Key).Select(pair => RuleOf(pair.Key).At(pair.Value.First, pair.Value.Details, FactText.Of(pair.Value.Texts))));
        if (_tilted is { } tilted) all.Add(LetteringRules.Tilted.At(tilted.First, FactText.Of(tilted.Count)));
        return all;
    }

    private static Diagnostic Substituted(FoundFont font)
    {
        var rule = font switch
        {
            { Trouble: FontTrouble.Broken } => LetteringRules.FontBroken,
            { Match: FontMatch.ByTable } => LetteringRules.FontMapped,
            _ => LetteringRules.FontMissing,
        };
        return rule.At(default, NameOf(font.Request), font.Font.Name);
    }

    /// <summary>As a style or a code names the font; "" if it names none.</summary>
    internal static string NameOf(FontRequest request) => request switch
    {
        { File.Length: > 0, Family.Length: 0 } => request.File,
        { Family.Length: > 0 } => string.Join(' ', new[] { request.Family, request.IsBold ? "Bold" : "", request.IsItalic ? "Italic" : "" }.Where(part => part.Length > 0)),
        _ => "",
    };

    private static DiagnosticRule RuleOf(LayoutNoteKind kind) => kind switch
    {
        LayoutNoteKind.GlyphSubstituted => LetteringRules.GlyphSubstituted,
        LayoutNoteKind.GlyphMissing => LetteringRules.GlyphMissing,
        LayoutNoteKind.GlyphBroken => LetteringRules.GlyphBroken,
        LayoutNoteKind.UnknownCode => LetteringRules.UnknownCode,
        LayoutNoteKind.FormIgnored => LetteringRules.FormIgnored,
        LayoutNoteKind.Unshaped => LetteringRules.Unshaped,
        _ => throw new UnreachableException(),
    };

    private static string Shown(string content) => content.Length <= ShownLength ? content : string.Concat(content.AsSpan(0, ShownLength - 1), "…");

    private sealed class Noted(SourceRef first)
    {
        private const int ShownDetails = 10;
        private readonly HashSet<string> _known = [];
        private readonly List<string> _shown = [];

        public SourceRef First { get; } = first;

        public int Texts { get; set; }

        public string Details => _known.Count > _shown.Count ? Wording.Get("LetteringFindings.More", string.Join(", ", _shown), _known.Count - _shown.Count) : string.Join(", ", _shown);

        public void Add(string detail)
        {
            if (_known.Add(detail) && _shown.Count < ShownDetails) _shown.Add(detail);
        }
    }
}
