using Engraver.Core.Geometry;
using Engraver.Core.Reshaping;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>Settings of FILLET or CHAMFER. Lengths in drawing units.</summary>
/// <param name="Radius">Radius of the arc; 0: a sharp corner.</param>
/// <param name="First">Chamfer distance on the first line.</param>
/// <param name="Second">Chamfer distance on the second line.</param>
/// <param name="IsChamfer">A chamfer instead of an arc.</param>
/// <param name="TrimsSides">Both objects are trimmed or extended to the joint; otherwise they are unchanged.</param>
internal sealed record FilletSettings(double Radius, double First, double Second, bool IsChamfer, bool TrimsSides)
{
    public Fillet? Of(Segment first, Point2D pickedFirst, Segment second, Point2D pickedSecond) => IsChamfer
        ? Fillet.Bevel(first, pickedFirst, second, pickedSecond, First, Second)
        : Fillet.Create(first, pickedFirst, second, pickedSecond, Radius);
}
