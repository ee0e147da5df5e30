using Engraver.App.Binding;
using Engraver.App.Desk;

namespace Engraver.App.Programs;

/// <summary>The job as a program of the controller (DMC).</summary>
/// <remarks>It is written when the page is first shown.</remarks>
public sealed class ProgramModel : PlaybackRows<ProgramRow>, IVisibilityAware
{
    private bool _isPageVisible;
    private IReadOnlyList<string> _shown = [];

    public ProgramModel(DesktopModel desk)
        : base(desk, () => desk.Derived.LineUnderTool, desk.Derived.MoveToLine, line => line.Index) => Subscribe();

    public bool IsPageVisible
    {
        get => _isPageVisible;
        set
        {
            if (SetProperty(ref _isPageVisible, value) && value) Refresh();
        }
    }

    protected override void Refresh()
    {
        if (!IsPageVisible)
        {
            Forget();
            return;
        }

        var lines = Desk.Derived.ProgramLines();
        if (ReferenceEquals(lines, _shown)) return;
        _shown = lines;
        Show(lines.Count, index => new ProgramRow(index, lines[index]));
    }

    /// <summary>A hidden page keeps no reference to the lines of an old program.</summary>
    private void Forget()
    {
        if (_shown.Count == 0 || Desk.Derived.HasLines) return;
        _shown = [];
        Show(0, _ => throw new ArgumentOutOfRangeException(nameof(Rows)));
    }
}
