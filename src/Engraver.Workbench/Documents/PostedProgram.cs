using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Galil.Programs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>A drawing as a program in one of the formats of the runner's contract.</summary>
/// <param name="Text">Null when there is nothing that the machine can cut.</param>
/// <param name="Diagnostics">Of every stage on the way.</param>
public sealed record PostedProgram(string? Text, IReadOnlyList<Diagnostic> Diagnostics)
{
    public const string Galil = "galil";

    public const string GalilCalls = "galil-calls";

    /// <summary>The targets there are.</summary>
    public static IReadOnlyList<string> Targets { get; } = [Galil, GalilCalls];

    /// <param name="target">One of <see cref="Targets"/>.</param>
    /// <exception cref="SettingException">A named layer or the entering entity is not in the drawing.</exception>
    public static PostedProgram Of(Drawing drawing, DrawingSettings settings, string target)
    {
        var calls = target == GalilCalls;
        var job = JobPreparation.Prepare(drawing, settings, calls ? MotionStyle.Calls : MotionStyle.Continuous);
        if (job.Motion.Program is not { } program) return new PostedProgram(null, job.Diagnostics);
        var post = calls ? DmcPost.Calls(program, DmcPostOptions.Default, drawing.SourceOf) : DmcPost.Sequences(program, DmcPostOptions.Default, drawing.SourceOf);
        return new PostedProgram(post.Text, [.. job.Diagnostics, .. post.Diagnostics]);
    }
}
