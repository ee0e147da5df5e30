using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Bitmaps;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>What a tile brush shows.</summary>
/// <param name="Size">In the brush's units.</param>
/// <param name="Resolution">Pixels of the picture per unit.</param>
internal sealed record TileContent(ITileBrush Brush, SoftwareBitmap Picture, Size Size, double Resolution);
