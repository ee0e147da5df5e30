namespace Engraver.App.Sessions;

/// <summary>The values of <c>--benchmark</c>: the measurement to run instead of the desktop.</summary>
internal static class BenchmarkName
{
    /// <summary>From the start of the process to its first frame, which is reported on standard output; then the window closes.</summary>
    public const string Start = "start";

    public const string Canvas = "canvas";

    /// <summary>Processor time of an idle window on a display, after opening drawing and script. Then the window closes.</summary>
    public const string Idle = "idle";

    public const string Stop = "stop";

    /// <summary>The same with keys sent to the window on a display from outside; with a drawing, a job is stopped too. Then the window closes.</summary>
    public const string StopOnDisplay = "stop-display";

    /// <summary>Frames of a window on a display while the view of the drawing moves. Then the window closes.</summary>
    public const string Frames = "frames";

    /// <summary>Repainting the whole window, at two sizes.</summary>
    public const string Repaint = "repaint";

    /// <summary>From OPEN to the first picture and to the end of all derivations.</summary>
    public const string Open = "open";

    /// <summary>Cost of a large drawing: processor time and memory of opening, planning, moving, closing and opening again.</summary>
    public const string Weight = "weight";

    /// <summary>The Plots page of a large drawing: first picture, frames, memory.</summary>
    public const string Plots = "plots";

    /// <summary>Layout and drawing of a page of text.</summary>
    public const string Text = "text";

    public static IReadOnlyList<string> All { get; } = [Start, Canvas, Stop, Repaint, Open, Weight, Text, Idle, StopOnDisplay, Frames, Plots];
}
