using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Sequencing;

namespace Engraver.App.Contours;

/// <summary>The contours in the order of cutting. The one under the tool is chosen; choosing one moves the tool there.</summary>
public sealed class ContoursModel : Observable
{
    private readonly WorkDesk _desk;
    private SequencingResult? _shown;
    private int _current = -1;

    public ContoursModel(WorkDesk desk)
    {
        _desk = desk;
        desk.Changed += Look;
        desk.Derived.Moved += LookWhereToolIs;
        Look();
    }

    public RowList<ContourRow> Rows { get; private set; } = new(0, _ => throw new ArgumentOutOfRangeException(nameof(Rows)), row => row.Index);

    public string Summary { get; private set; } = "";

    public int Current
    {
        get => _current;
        set
        {
            if (Set(ref _current, value) && value >= 0) _desk.Derived.MoveToStroke(value);
        }
    }

    private void Look()
    {
        if (ReferenceEquals(_desk.Derived.Sequence, _shown)) return;
        _shown = _desk.Derived.Sequence;
        var strokes = _shown?.Strokes ?? [];
        Rows = new RowList<ContourRow>(strokes.Count, index => new ContourRow(strokes[index]), row => row.Index);
        Summary = _shown is null ? "" : Text.Of("Contours.Summary", Text.Count("Count.Contour", _shown.Contours), _shown.Closed, _shown.Open, _shown.PathLength, _shown.Travel);
        Tell(nameof(Rows));
        Tell(nameof(Summary));
        LookWhereToolIs();
    }

    private void LookWhereToolIs() => Set(ref _current, _desk.Derived.StrokeUnderTool, nameof(Current));
}
