using Engraver.Core.Geometry;
using Engraver.Galil.Programs;

namespace Engraver.Workbench.Playback;

/// <summary>What the planned motion does at one moment.</summary>
/// <param name="Seconds">Since the job began.</param>
/// <param name="Position">Where the tool is, drawing millimetres.</param>
/// <param name="Speed">Along the path, mm/s.</param>
/// <param name="ToolOn">The tool output is on.</param>
/// <param name="Kind">Cutting, between strokes, or standing.</param>
/// <param name="Stroke">Index of the stroke (contour) in the order of cutting.</param>
/// <param name="Segment">Place of the segment in the whole motion program: the one that is cut, or the next one.</param>
/// <param name="Entity">The drawing entity of that segment.</param>
/// <param name="Row">Row of the sequenced entity table of that segment.</param>
/// <param name="Line">Line of the posted program that commands that segment, 1 is first; 0 when no program was posted.</param>
public readonly record struct PlaybackMoment(double Seconds, Point2D Position, double Speed, bool ToolOn, MotionSpanKind Kind, int Stroke, int Segment, int Entity, int Row, int Line);
