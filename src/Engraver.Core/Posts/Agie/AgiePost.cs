using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Posts.Agie;

/// <summary>The job as programs for the wire eroder AGIECUT DEM15 (paper 000). It counts from the machine position: the start of the first stroke, where the
/// wire is threaded.</summary>
public sealed class AgiePost : IPost
{
    /// <summary>The style value that selects the paper's blocks.</summary>
    public const string PaperStyle = "paper";

    public const string ExactStyle = "exact";

    private const string OwnLine = "own-line";
    private const string SameLine = "same-line";

    /// <summary>The format of the blocks.</summary>
    public static PostOption Style => new("style", "STYLE", Wording.Get("AgiePost.Style"), ExactStyle, Wording.Get("AgiePost.OneOfTwo", ExactStyle, PaperStyle), value => value is ExactStyle or PaperStyle);

    private static PostOption StartMark => new("start-mark", "PLACE", Wording.Get("AgiePost.StartMark"), SameLine, Wording.Get("AgiePost.OneOfTwo", SameLine, OwnLine), value => value is SameLine or OwnLine);

    public string Name => "agie";

    public string Summary => Wording.Get("AgiePost.Summary");

    public string FileExtension => ".agie";

    public PostGeometry Geometry => PostGeometry.LinesAndArcs;

    public MotionStyle? Motion => null;

    public IReadOnlyList<PostOption> Options => [Style, StartMark];

    public string? OperationsRefusal => Wording.Get("AgiePost.NoOperations");

    public PostOutput Write(PostRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        var (path, isPaper) = (request.Path, request.Value(Style) == PaperStyle);
        if (path.Strokes.Count == 0) return new PostOutput([], [DocumentRules.NothingToPost.At(default)]);
        if (isPaper && AgiePaperBlocks.Unwritable(path) is { } entity) return Refused(PostRules.RadiusNotWritable.At(request.SourceOf?.Invoke(entity) ?? default, NumberText.Rounded(AgieBlock.Largest / 1000.0, 4)));
        var made = isPaper ? AgiePaperBlocks.Write(path) : AgieExactBlocks.Write(path);
        if (made.TooMany) return Refused(PostRules.TooManyBlocks.At(default, NumberText.Rounded(AgieSteps.MaxCount, 4)));
        if (made.All.Count == 0) return Refused(PostRules.NothingToMove.At(default));
        return Written(path, made.All, request.Value(StartMark) == OwnLine);
    }

    private static PostOutput Written(Toolpath path, IReadOnlyList<AgieStep> steps, bool ownLine)
    {
        var parts = AgieText.Parts(steps);
        var forecast = AgieForecast.Follow(path, steps, parts);
        var text = AgieText.Programs(steps, parts, ownLine) with { Forecast = forecast };
        return forecast.MaxError * 1000.0 > AgieExactBlocks.ContourError ? text with { Diagnostics = [.. text.Diagnostics, WholeDegrees(forecast)] } : text;
    }

    private static Diagnostic WholeDegrees(PostForecast forecast)
    {
        var worst = forecast.Blocks.MaxBy(block => block.Error ?? 0.0)!;
        return PostRules.ContourError.At(default, NumberText.Rounded(forecast.MaxError, 4), NumberText.Rounded(worst.End.X, 4), NumberText.Rounded(worst.End.Y, 4), NumberText.Rounded(worst.Number, 4), forecast.MaxClosure is { } closure ? Wording.Get("AgiePost.LargestGap", NumberText.Rounded(closure, 4)) : Wording.Get("AgiePost.NoClosedContour")) with { Place = worst.End };
    }

    private static PostOutput Refused(Diagnostic why) => new([], [why]);
}
