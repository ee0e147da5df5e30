using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;

namespace Engraver.Core.Posts.Hpgl;

/// <summary>The job for plotters and cutters that read HP-GL/2 (rs274-hpgl.md 3): absolute positions in whole units of the format, so that rounding errors do
/// not accumulate.</summary>
public sealed class HpglPost : IPost
{
    private const int MostPens = 8;

    /// <summary>Arcs as chords of rounded places.</summary>
    private const string Chords = "chords";

    /// <summary>Arcs as AA where the rounded centre and start allow it.</summary>
    private const string Arcs = "aa";

    private static PostOption Units => new("units-per-mm", "N", Wording.Get("HpglPost.Units"), "40", Wording.Get("HpglPost.WholeFromTo", 10, 10000), value => Whole(value) is >= 10 and <= 10000);

    private static PostOption ArcForm => new("arcs", "FORM", Wording.Get("HpglPost.Arcs"), Chords, $"{Chords} | {Arcs}", value => value is Chords or Arcs);

    private static PostOption Pen => new("pen", "N", Wording.Get("HpglPost.Pen"), "1", Wording.Get("HpglPost.WholeFromTo", 1, MostPens), value => Whole(value) is >= 1 and <= MostPens);

    public string Name => "hpgl";

    public string Summary => Wording.Get("HpglPost.Summary");

    public string FileExtension => ".plt";

    public PostGeometry Geometry => PostGeometry.LinesAndArcs;

    public MotionStyle? Motion => null;

    public IReadOnlyList<PostOption> Options => [Units, ArcForm, Pen];

    public string? OperationsRefusal => null;

    public PostOutput Write(PostRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        if (request.Path.Strokes.Count == 0) return new PostOutput([], [DocumentRules.NothingToPost.At(default)]);
        var sheet = new HpglSheet(Whole(request.Value(Units))!.Value);
        if (Beyond(request, sheet) is { } beyond) return new PostOutput([], [beyond]);
        IReadOnlyList<Diagnostic> ofOperations = request.Operations is { } operations ? [.. OfOperations(operations, request.Options.ContainsKey(Pen.Name))] : [];
        if (ofOperations.Any(finding => finding.Severity == Severity.Error)) return new PostOutput([], ofOperations);
        var program = new HpglProgram(sheet, request.Value(ArcForm) == Arcs);
        var pen = int.Parse(request.Value(Pen), CultureInfo.InvariantCulture);
        var text = program.Write(request.Path, stroke => request.Operations?.OperationOf(stroke).Tool ?? pen, request.Machine.FeedMmPerMinute);
        return new PostOutput([text], [.. ofOperations, PostRules.Rounded.At(default, FactText.Of(sheet.Unit), FactText.Of(program.LargestError), FactText.Of(program.ErrorAt.X), FactText.Of(program.ErrorAt.Y)) with { Place = program.ErrorAt }]);
    }

    /// <summary>A pen is up or down: there are no depths, waits and spindles, and the pen is the number of the tool.</summary>
    private static IEnumerable<Diagnostic> OfOperations(PostOperations operations, bool hasPen)
    {
        if (hasPen) yield return OperationRules.NotInFormat.At(default, "hpgl", "--pen", operations.All.First().Title);
        foreach (var operation in operations.All)
        {
            if (operation.Depth is not null) yield return OperationRules.NotInFormat.At(default, "hpgl", "depth", operation.Title);
            if (operation.StopsBetween) yield return OperationRules.NotInFormat.At(default, "hpgl", "stopBetween", operation.Title);
            if (operation.Tool > MostPens) yield return OperationRules.NotInFormat.At(default, "hpgl", $"tool {FactText.Of(operation.Tool)}", operation.Title);
            if (operation.PierceSeconds > 0.0) yield return OperationRules.LeftOut.At(default, "hpgl", "pierce", operation.Title);
            if (operation.Outputs.Count > 0) yield return OperationRules.LeftOut.At(default, "hpgl", "outputs", operation.Title);
            if (operations.Plan.SpindleOf(operation) is { } speed) yield return OperationRules.SpindleByHand.At(default, operation.Title, FactText.Of(speed));
        }
    }

    private static Diagnostic? Beyond(PostRequest request, HpglSheet sheet)
    {
        foreach (var move in request.Path.Strokes.SelectMany(stroke => stroke.Moves))
        {
            var box = move.Segment.Bounds;
            if (new[] { Math.Abs(box.MinX), Math.Abs(box.MinY), Math.Abs(box.MaxX), Math.Abs(box.MaxY) }.Max() <= sheet.Largest) continue;
            return PostRules.PlaceNotWritable.At(request.SourceOf?.Invoke(move.EntityIndex) ?? default, FactText.Of(move.Segment.Start.X), FactText.Of(move.Segment.Start.Y), FactText.Of(Math.Floor(sheet.Largest)));
        }

        return null;
    }

    private static int? Whole(string text) => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out var number) ? number : null;
}
