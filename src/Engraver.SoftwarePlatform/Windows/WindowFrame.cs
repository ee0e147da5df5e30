using System.Runtime.InteropServices;
using Avalonia;
using Avalonia.Platform;

namespace Engraver.SoftwarePlatform.Windows;

/// <summary>The pixels of a window: BGRA, premultiplied, rows from the top, no padding.</summary>
internal sealed unsafe class WindowFrame : IDisposable
{
    private void* _pixels;

    public WindowFrame(PixelSize size)
    {
        Size = size;
        _pixels = NativeMemory.AllocZeroed((nuint)Math.Max(1, size.Width * size.Height), 4);
    }

    public PixelSize Size { get; }

    public int Stride => Size.Width * 4;

    public nint Address => (nint)_pixels;

    public ReadOnlySpan<uint> Pixels => new(_pixels, Size.Width * Size.Height);

    public ILockedFramebuffer Lock(double scaling, Action presented) =>
        new LockedFramebuffer(Address, Size, Stride, new Vector(96, 96) * scaling, PixelFormat.Bgra8888, AlphaFormat.Premul, presented);

    public void Dispose()
    {
        NativeMemory.Free(_pixels);
        _pixels = null;
    }
}
