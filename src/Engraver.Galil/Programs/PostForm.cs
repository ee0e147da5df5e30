namespace Engraver.Galil.Programs;

/// <summary>How one way of posting spells its parts; packing them into chunks is the same for all.</summary>
/// <param name="Opening">From the label #JOB to before the first stroke; the argument is how many stroke lines earlier chunks have run.</param>
/// <param name="Stroke">Rapid, tool on, cut, tool off.</param>
/// <param name="Closing">End of the job and every subprogram.</param>
internal sealed record PostForm(
    Func<int, IReadOnlyList<string>> Opening, Func<MotionStroke, IReadOnlyList<string>> Stroke, IReadOnlyList<string> Closing);
