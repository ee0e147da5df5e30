using Engraver.Core.Drawings;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>The visible texts on the selected layers of a drawing whose settings do not cut texts.</summary>
public static class UncutTexts
{
    /// <summary>Their number; 0 if texts are cut.</summary>
    public static int Count(Drawing drawing, DrawingSettings settings)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(settings);
        return drawing.Texts.Count == 0 || settings.Cut.HasFlag(CutChoice.Text) ? 0 : drawing.Texts.Count(LetterStage.TakenBy(drawing, settings));
    }
}
