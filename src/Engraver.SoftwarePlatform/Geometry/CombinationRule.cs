using Avalonia.Media;

namespace Engraver.SoftwarePlatform.Geometry;

/// <summary>Decides whether a point is inside the result, from the winding numbers of both paths around it.</summary>
internal sealed record CombinationRule(FillRule FirstRule, FillRule SecondRule, GeometryCombineMode Mode)
{
    public bool Holds(int firstWinding, int secondWinding)
    {
        var first = IsInside(firstWinding, FirstRule);
        var second = IsInside(secondWinding, SecondRule);
        return Mode switch
        {
            GeometryCombineMode.Union => first || second,
            GeometryCombineMode.Intersect => first && second,
            GeometryCombineMode.Xor => first != second,
            _ => first && !second,
        };
    }

    private static bool IsInside(int winding, FillRule rule) => rule == FillRule.EvenOdd ? winding % 2 != 0 : winding != 0;
}
