using System.Runtime.CompilerServices;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Geometry.Biarcs;
using Engraver.Core.Unions;
using Engraver.Fonts;

namespace Engraver.Workbench.Lettering;

/// <summary>Unites the outlines of a text where they overlap: contours of a glyph (variable fonts), and neighbours (script fonts, narrow tracking), by the
/// non-zero winding rule. Contours that no other crosses are returned as they are.</summary>
/// <param name="plane">The plane of the text; it must be level.</param>
/// <param name="maxError">Largest distance of the arcs that replace curves of united outlines, drawing units.</param>
internal sealed class OutlineUnion(Placement plane, double maxError)
{
    /// <summary>Distance that counts as zero, as a part of the error of the arcs.</summary>
    private const double ZeroShare = 1e-3;

    private static readonly ConditionalWeakTable<GlyphCurves, StrongBox<bool>> s_crossings = [];

    private readonly List<Letter> _letters = [];

    public bool IsLevel => plane.XAxis.Z == 0.0 && plane.YAxis.Z == 0.0;

    /// <summary>False if some could not be united: they are as they were added.</summary>
    public bool IsComplete { get; private set; } = true;

    /// <param name="glyph">The glyph of the contours.</param>
    public void Add(GlyphCurves glyph, IReadOnlyList<LetterContour> contours) =>
        _letters.Add(new Letter(contours, contours.Aggregate(Bounds2D.Empty, (box, contour) => box.Union(contour.Bounds)), IsCrossing(glyph)));

    /// <summary>The contours in the order of their letters.</summary>
    public IEnumerable<LetterContour> Unite() => Groups().SelectMany(group => group.Count == 1 && !group[0].Crosses ? group[0].Contours : Unite([.. group.SelectMany(letter => letter.Contours)]));

    /// <summary>True if the contours of a glyph cross each other or themselves; found out once for each glyph.</summary>
    private static bool IsCrossing(GlyphCurves glyph) => s_crossings.GetValue(glyph, one => new StrongBox<bool>(FindsCrossing(one))).Value;

    private static bool FindsCrossing(GlyphCurves glyph)
    {
        var size = Math.Max(glyph.Advance, 1.0);
        List<LetterContour> contours = [.. glyph.Contours.Select(contour => LetterContour.Of(contour, Placement.Identity))];
        var given = contours.ConvertAll(contour => SegmentsOf(contour, 1e-3 * size));
        var united = ContourUnion.Unite(given, 1e-6 * size);
        return !united.IsComplete || united.Contours.Count != given.Count || !united.Contours.All(one => given.Exists(contour => IsSame(one, contour)));
    }

    private IReadOnlyList<LetterContour> Unite(List<LetterContour> contours)
    {
        var given = contours.ConvertAll(contour => SegmentsOf(contour, maxError));
        var united = ContourUnion.Unite(given, ZeroShare * maxError);
        if (!united.IsComplete)
        {
            IsComplete = false;
            return contours;
        }

        return [.. united.Contours.Select(one => given.FindIndex(contour => IsSame(one, contour)) is >= 0 and var same ? contours[same] : LetterContour.Of(one, plane.Origin.Z))];
    }

    private static IReadOnlyList<Segment> SegmentsOf(LetterContour contour, double error) => BiarcFit.FitContour(contour.Parts.Select(part => contour.SegmentOf(part)), error);

    /// <summary>True for a contour that was returned as given, or reversed.</summary>
    private static bool IsSame(IReadOnlyList<Segment> united, IReadOnlyList<Segment> given)
    {
        if (united.Count != given.Count) return false;
        var indices = Enumerable.Range(0, given.Count);
        return indices.All(i => united[i].Start == given[i].Start && united[i].End == given[i].End) || indices.All(i => united[i].Start == given[^(i + 1)].End && united[i].End == given[^(i + 1)].Start);
    }

    /// <summary>Letters whose boxes overlap, directly or by others between them; in the order of their first letters.</summary>
    private List<List<Letter>> Groups()
    {
        var group = new int[_letters.Count];
        for (var i = 0; i < group.Length; i++) group[i] = i;
        var order = Enumerable.Range(0, group.Length).OrderBy(i => _letters[i].Box.MinX).ToList();
        var open = new List<int>();
        foreach (var letter in order)
        {
            var box = _letters[letter].Box;
            open.RemoveAll(other => _letters[other].Box.MaxX < box.MinX);
            foreach (var other in open.Where(other => _letters[other].Box.MinY <= box.MaxY && _letters[other].Box.MaxY >= box.MinY)) Join(group, letter, other);
            open.Add(letter);
        }

        return [.. Enumerable.Range(0, group.Length).GroupBy(letter => Root(group, letter)).Select(members => members.Select(letter => _letters[letter]).ToList())];
    }

    private static void Join(int[] group, int one, int other)
    {
        var (first, second) = (Root(group, one), Root(group, other));
        group[Math.Max(first, second)] = Math.Min(first, second);
    }

    private static int Root(int[] group, int letter)
    {
        while (group[letter] != letter) letter = group[letter] = group[group[letter]];
        return letter;
    }

    private sealed record Letter(IReadOnlyList<LetterContour> Contours, Bounds2D Box, bool Crosses);
}
