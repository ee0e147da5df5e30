using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core.Sequencing;

namespace Engraver.App.Contours;

/// <summary>The contours in cutting order.</summary>
public sealed class ContoursModel : PlaybackRows<ContourRow>
{
    private SequencingResult? _shown;

    public ContoursModel(DesktopModel desk)
        : base(desk, () => desk.Derived.StrokeUnderTool, desk.Derived.MoveToStroke, row => row.Index) => Subscribe();

    public string Summary { get; private set; } = "";

    protected override void Refresh()
    {
        if (ReferenceEquals(Desk.Derived.Sequence, _shown)) return;
        _shown = Desk.Derived.Sequence;
        Summary = _shown is null ? "" : Text.Get("Contours.Summary", Text.Count("Count.Contour", _shown.Contours), _shown.Closed, _shown.Open, _shown.PathLength, _shown.Travel);
        OnPropertyChanged(nameof(Summary));
        var strokes = _shown?.Strokes ?? [];
        Show(strokes.Count, index => new ContourRow(strokes[index]));
    }
}
