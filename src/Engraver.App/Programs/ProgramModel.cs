using Engraver.App.Binding;
using Engraver.App.Desk;

namespace Engraver.App.Programs;

/// <summary>The job as the controller's own program (DMC). The line under the tool is chosen; choosing one moves the tool there.</summary>
public sealed class ProgramModel : Observable
{
    private readonly WorkDesk _desk;
    private IReadOnlyList<string> _shown = [];
    private int _current = -1;

    public ProgramModel(WorkDesk desk)
    {
        _desk = desk;
        desk.Changed += Look;
        desk.Derived.Moved += LookWhereToolIs;
        Look();
    }

    public RowList<ProgramLine> Lines { get; private set; } = new(0, _ => throw new ArgumentOutOfRangeException(nameof(Lines)), line => line.Index);

    public bool IsEmpty => Lines.Count == 0;

    public int Current
    {
        get => _current;
        set
        {
            if (Set(ref _current, value) && value >= 0) _desk.Derived.MoveToLine(value);
        }
    }

    private void Look()
    {
        var lines = _desk.Derived.ProgramLines();
        if (ReferenceEquals(lines, _shown)) return;
        _shown = lines;
        Lines = new RowList<ProgramLine>(lines.Count, index => new ProgramLine(index, lines[index]), line => line.Index);
        Tell(nameof(Lines));
        Tell(nameof(IsEmpty));
        LookWhereToolIs();
    }

    private void LookWhereToolIs() => Set(ref _current, _desk.Derived.LineUnderTool, nameof(Current));
}
