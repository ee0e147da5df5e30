using Engraver.Core.Geometry;
using Engraver.Core.Motion;

namespace Engraver.Workbench.Playback;

/// <summary>State of the planned motion at one time.</summary>
/// <param name="Seconds">Since the start of the job.</param>
/// <param name="Position">Tool position, drawing millimetres.</param>
/// <param name="Speed">Along the path, mm/s.</param>
/// <param name="ToolOn">The tool output is on.</param>
/// <param name="Kind">Cutting, between strokes, or at a standstill.</param>
/// <param name="Stroke">Index of the stroke (contour) in the order of cutting.</param>
/// <param name="Segment">Index in the whole motion program of the current or next segment.</param>
/// <param name="Entity">The drawing entity of that segment.</param>
/// <param name="Move">Toolpath move of that segment, numbered over all strokes; an ellipse or spline consists of several.</param>
/// <param name="Row">Row of the sequenced entity table of that segment.</param>
public readonly record struct PlaybackMoment(double Seconds, Point2D Position, double Speed, bool ToolOn, MotionSpanKind Kind, int Stroke, int Segment, int Entity, int Move, int Row);
