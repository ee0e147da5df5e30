using Avalonia;

namespace Engraver.SoftwarePlatform.X11.Protocol;

/// <summary>WM_NORMAL_HINTS (ICCCM 4.1.2.3): how large the window may be, in pixels.</summary>
internal sealed class SizeHints
{
    private const int Largest = 32767; // the protocol's
    private const nint ProgramPosition = 1 << 2;
    private const nint MinSize = 1 << 4;
    private const nint MaxSize = 1 << 5;
    private PixelSize _min = new(1, 1);
    private PixelSize _max = new(Largest, Largest);

    /// <summary>Null leaves the place to the window manager.</summary>
    public PixelPoint? Position { get; set; }

    public PixelSize Size { get; set; }

    public bool CanResize { get; set; } = true;

    /// <summary>In device independent units; infinite or zero means no limit.</summary>
    public void SetLimits(Size min, Size max, double scale)
    {
        _min = new PixelSize(AtLeastOne(min.Width * scale), AtLeastOne(min.Height * scale));
        _max = new PixelSize(AtMost(max.Width * scale), AtMost(max.Height * scale));
    }

    public nint[] Pack()
    {
        var (min, max) = CanResize ? (_min, _max) : (Size, Size);
        var place = Position ?? default;
        var flags = MinSize | MaxSize | (Position is null ? 0 : ProgramPosition);
        return [flags, place.X, place.Y, Size.Width, Size.Height, min.Width, min.Height, max.Width, max.Height, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    }

    private static int AtLeastOne(double pixels) => (int)Math.Clamp(Math.Ceiling(pixels - 1e-6), 1, Largest);

    private static int AtMost(double pixels) => pixels is > 0 and < Largest ? (int)Math.Ceiling(pixels - 1e-6) : Largest;
}
