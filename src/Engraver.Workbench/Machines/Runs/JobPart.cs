using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The part of the drawing that START cuts: the rest of an interrupted job, or the contours from one on. Valid until it is cut or the drawing, the
/// settings or the work origin change.</summary>
/// <param name="Shown">Start of the part; earlier segments are shown as done.</param>
/// <param name="Strategy">The strategy with which it was started; null where that is not known.</param>
/// <param name="Drawing">The drawing of the part.</param>
/// <param name="Settings">The settings of the part.</param>
public sealed record JobPart(ResumeRequest Request, JobPosition Shown, ExecutionStrategy? Strategy, Drawing Drawing, DrawingSettings Settings)
{
    /// <summary>The interrupted plate; null for a part that is not one of a plate.</summary>
    public Plate? Plate { get; init; }

    /// <summary>The change of the tool or the stop before it: the operator may set the height of the work, and the part remains. Null for another
    /// part.</summary>
    public SectionBreak? Break { get; init; }
}
