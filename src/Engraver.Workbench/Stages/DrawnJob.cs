using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Stages;

/// <summary>What the preparation of a job starts with. The state behind each stage is derived from an earlier state and adds the result of the
/// stage.</summary>
/// <param name="Drawing">What is cut. A stage may replace it; entity indices refer to it.</param>
/// <param name="Settings">The settings of the operator.</param>
/// <param name="Style">Continuous for streaming and posted sequences, calls for the subroutine calls of paper 000.</param>
public record DrawnJob(Drawing Drawing, DrawingSettings Settings, MotionStyle Style = MotionStyle.Continuous)
{
    /// <summary>The drawing as it was opened.</summary>
    public Drawing Source { get; init; } = Drawing;

    /// <summary>What the fields in its texts stand for.</summary>
    public PlateValues Values { get; init; } = PlateValues.None;

    /// <summary>Ends the search for its order early; null if it cannot be ended.</summary>
    public OrderStop? OrderStop { get; init; }

    /// <summary>Findings that are not in the result of a stage, in the order of their report.</summary>
    public IReadOnlyList<Diagnostic> Findings { get; init; } = [];
}
