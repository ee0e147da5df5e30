using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Trajectories.Formats;
using Engraver.Core.Trajectories.Reading;

namespace Engraver.Core.Trajectories.Posting;

/// <summary>The job as trajectories of an XPS controller (sace-xps-agie.md 2), all of them in one text: a line states the required machine position, then the
/// lines of one file follow. The verb <c>trajectory</c> writes the same files one by one.</summary>
/// <param name="format">One of the XPS formats.</param>
/// <param name="name">Name as in <c>--target</c>.</param>
/// <param name="ending">Extension of its files.</param>
public sealed class XpsPost(TrajectoryFormat format, string name, string ending) : IPost
{
    public string Name => name;

    public string Summary => Wording.Get("XpsPost." + format);

    public string FileExtension => ending;

    public PostGeometry Geometry => PostGeometry.Curves;

    public MotionStyle? Motion => null;

    public IReadOnlyList<PostOption> Options => [];

    public string? OperationsRefusal => Wording.Get("XpsPost.NoOperations");

    public PostOutput Write(PostRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        if (request.Path.Strokes.Count == 0) return new PostOutput([], [DocumentRules.NothingToPost.At(default)]);
        var (motion, options) = (TrajectoryMotion.Of(request.Machine), new TrajectoryOptions(request.MaxErrorMm));
        var (parts, findings) = (new List<string>(), new List<Diagnostic>());
        foreach (var stroke in request.Path.Strokes)
        {
            var made = TrajectoryFiles.Write([.. stroke.Moves.Select(move => move.Segment)], stroke.Closed, options, format, motion);
            foreach (var file in made.Files)
            {
                parts.Add(Marked(file));
                findings.AddRange(TrajectoryFindings.LimitsOf(file, Wording.Get("XpsPost.Part", parts.Count), motion));
            }

            findings.AddRange(TrajectoryFindings.NotKept(made.Unproven, request.MaxErrorMm));
        }

        return findings.Any(finding => finding.Severity == Severity.Error) ? new PostOutput([], findings) : new PostOutput(parts, findings);
    }

    private static string Marked(TrajectoryFile file) => string.Create(CultureInfo.InvariantCulture, $"{TrajectoryReader.Mark}{file.Start.X:R} {file.Start.Y:R}\n{file.Text.ReplaceLineEndings("\n").TrimEnd('\n')}\n");
}
