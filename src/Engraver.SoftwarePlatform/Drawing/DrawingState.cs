using Avalonia;
using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>What a pop brings back, and what it has to finish.</summary>
/// <param name="OwnMask">Mask that the push made; nobody needs it after the pop.</param>
/// <param name="Layer">Group that the push began, to be put onto what was drawn on before.</param>
internal readonly record struct DrawingState(Matrix Transform, double Opacity, ClipShape Clip, CoverageMask? OwnMask, DrawingLayer? Layer);
