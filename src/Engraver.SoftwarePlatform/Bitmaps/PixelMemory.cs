using System.Runtime.InteropServices;

namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Zeroed memory outside the managed heap, freed when disposed or finalised.</summary>
internal sealed unsafe class PixelMemory : SafeHandle
{
    private readonly long _bytes;

    public PixelMemory(long pixels)
        : base(IntPtr.Zero, ownsHandle: true)
    {
        _bytes = pixels * sizeof(uint);
        SetHandle((IntPtr)NativeMemory.AllocZeroed((nuint)pixels, sizeof(uint)));
        GC.AddMemoryPressure(_bytes);
    }

    public override bool IsInvalid => handle == IntPtr.Zero;

    public uint* Pixels
    {
        get
        {
            ObjectDisposedException.ThrowIf(IsClosed, this);
            return (uint*)handle;
        }
    }

    protected override bool ReleaseHandle()
    {
        NativeMemory.Free((void*)handle);
        GC.RemoveMemoryPressure(_bytes);
        return true;
    }
}
