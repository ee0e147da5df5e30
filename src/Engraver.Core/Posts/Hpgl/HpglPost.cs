using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;

namespace Engraver.Core.Posts.Hpgl;

/// <summary>The job for plotters and cutters that read HP-GL/2 (rs274-hpgl.md 3): absolute positions in whole units of the format, so that rounding errors do
/// not accumulate.</summary>
public sealed class HpglPost : IPost
{
    /// <summary>Arcs as chords of rounded places.</summary>
    private const string Chords = "chords";

    /// <summary>Arcs as AA where the rounded centre and start allow it.</summary>
    private const string Arcs = "aa";

    private static PostOption Units => new("units-per-mm", "N", Wording.Get("HpglPost.Units"), "40", Wording.Get("HpglPost.WholeFromTo", 10, 10000), value => Whole(value) is >= 10 and <= 10000);

    private static PostOption ArcForm => new("arcs", "FORM", Wording.Get("HpglPost.Arcs"), Chords, $"{Chords} | {Arcs}", value => value is Chords or Arcs);

    private static PostOption Pen => new("pen", "N", Wording.Get("HpglPost.Pen"), "1", Wording.Get("HpglPost.WholeFromTo", 1, 8), value => Whole(value) is >= 1 and <= 8);

    public string Name => "hpgl";

    public string Summary => Wording.Get("HpglPost.Summary");

    public string FileExtension => ".plt";

    public PostGeometry Geometry => PostGeometry.LinesAndArcs;

    public MotionStyle? Motion => null;

    public IReadOnlyList<PostOption> Options => [Units, ArcForm, Pen];

    public PostOutput Write(PostRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        if (request.Path.Strokes.Count == 0) return new PostOutput([], [DocumentRules.NothingToPost.At(default)]);
        var sheet = new HpglSheet(Whole(request.Value(Units))!.Value);
        if (Beyond(request, sheet) is { } beyond) return new PostOutput([], [beyond]);
        var program = new HpglProgram(sheet, request.Value(ArcForm) == Arcs);
        var text = program.Write(request.Path, int.Parse(request.Value(Pen), CultureInfo.InvariantCulture), request.Machine.FeedMmPerMinute);
        return new PostOutput([text], [PostRules.Rounded.At(default, FactText.Of(sheet.Unit), FactText.Of(program.LargestError), FactText.Of(program.ErrorAt.X), FactText.Of(program.ErrorAt.Y)) with { Place = program.ErrorAt }]);
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
