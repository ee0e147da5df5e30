using Avalonia;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Bitmaps;
using Engraver.SoftwarePlatform.Rasteriser;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>A group that is drawn apart and then put in its place through a mask or with an opacity.</summary>
/// <param name="Bitmap">Stands for the device pixels of <paramref name="Bounds"/>.</param>
/// <param name="Beneath">What was drawn on before.</param>
/// <param name="Mask">Brush whose alpha counts; null for a group that only has an opacity.</param>
/// <param name="MaskArea">The brush's target, in the coordinates at the push.</param>
internal sealed record DrawingLayer(SoftwareBitmap Bitmap, PixelBounds Bounds, SurfacePainter Beneath, IBrush? Mask, Rect MaskArea, double GroupOpacity);
