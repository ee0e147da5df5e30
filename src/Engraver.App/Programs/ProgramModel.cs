using Engraver.App.Desk;

namespace Engraver.App.Programs;

/// <summary>The job as the controller's own program (DMC).</summary>
public sealed class ProgramModel : FollowedRows<ProgramLine>
{
    private IReadOnlyList<string> _shown = [];

    public ProgramModel(DesktopModel desk)
        : base(desk, () => desk.Derived.LineUnderTool, desk.Derived.MoveToLine, line => line.Index) => Follow();

    protected override void Look()
    {
        var lines = Desk.Derived.ProgramLines();
        if (ReferenceEquals(lines, _shown)) return;
        _shown = lines;
        Show(lines.Count, index => new ProgramLine(index, lines[index]));
    }
}
