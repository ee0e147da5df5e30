namespace Engraver.Workbench.Lettering;

/// <summary>Collects what a layout reports, each once.</summary>
public sealed class LayoutNotes
{
    private readonly List<LayoutNote> _notes = [];
    private readonly HashSet<LayoutNote> _known = [];

    public IReadOnlyList<LayoutNote> All => _notes;

    public void Add(LayoutNoteKind kind, string detail)
    {
        var note = new LayoutNote(kind, detail);
        if (_known.Add(note)) _notes.Add(note);
    }

    public void AddCodes(IEnumerable<string> codes)
    {
        ArgumentNullException.ThrowIfNull(codes);
        foreach (var code in codes) Add(LayoutNoteKind.UnknownCode, code);
    }
}
