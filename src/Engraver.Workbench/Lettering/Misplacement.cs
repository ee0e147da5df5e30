using Engraver.Core.Geometry;

namespace Engraver.Workbench.Lettering;

/// <summary>The largest distance of the curves of a text from their places, drawing units; infinite for a curve that is missing or one too many.</summary>
internal readonly record struct Misplacement(double Distance, Vector3D At);
