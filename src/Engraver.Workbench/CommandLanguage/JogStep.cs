using Engraver.Core.Geometry;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Direction of a jog.</summary>
/// <param name="Displacement">Millimetres of the drawing's axes; a direction has length 1.</param>
/// <param name="DisplacementZ">The same for Z.</param>
/// <param name="HasDistance">The distance is included; otherwise only the direction is given.</param>
internal sealed record JogStep(Vector2D Displacement, double DisplacementZ, bool HasDistance);
