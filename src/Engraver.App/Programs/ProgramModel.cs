using Engraver.App.Binding;
using Engraver.App.Desk;

namespace Engraver.App.Programs;

/// <summary>The job as a program of the controller (DMC).</summary>
/// <remarks>It is written when the page is first shown.</remarks>
public sealed class ProgramModel : FollowedRows<ProgramLine>, ISeen
{
    private bool _isSeen;
    private IReadOnlyList<string> _shown = [];

    public ProgramModel(DesktopModel desk)
        : base(desk, () => desk.Derived.LineUnderTool, desk.Derived.MoveToLine, line => line.Index) => Follow();

    public bool IsSeen
    {
        get => _isSeen;
        set
        {
            if (Set(ref _isSeen, value) && value) Look();
        }
    }

    protected override void Look()
    {
        if (!IsSeen)
        {
            Forget();
            return;
        }

        var lines = Desk.Derived.ProgramLines();
        if (ReferenceEquals(lines, _shown)) return;
        _shown = lines;
        Show(lines.Count, index => new ProgramLine(index, lines[index]));
    }

    /// <summary>A hidden page keeps no reference to the lines of an old program.</summary>
    private void Forget()
    {
        if (_shown.Count == 0 || Desk.Derived.HasLines) return;
        _shown = [];
        Show(0, _ => throw new ArgumentOutOfRangeException(nameof(Rows)));
    }
}
