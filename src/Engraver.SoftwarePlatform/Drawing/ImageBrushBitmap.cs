using System.Runtime.CompilerServices;
using Avalonia.Media;
using Engraver.SoftwarePlatform.Bitmaps;

namespace Engraver.SoftwarePlatform.Drawing;

/// <summary>The only use of an internal member of Avalonia 12.1.6: an image brush does not show its bitmap to a platform outside Avalonia.</summary>
internal static class ImageBrushBitmap
{
    public static SoftwareBitmap? Find(IImageBrushSource source)
    {
        var reference = Reference(source);
        return reference?.GetType().GetProperty("Item")?.GetValue(reference) as SoftwareBitmap;
    }

    [UnsafeAccessor(UnsafeAccessorKind.Method, Name = "get_Bitmap")]
    [return: UnsafeAccessorType("Avalonia.Utilities.IRef`1[[Avalonia.Platform.IBitmapImpl, Avalonia.Base]], Avalonia.Base")]
    private static extern object? Reference(IImageBrushSource source);
}
