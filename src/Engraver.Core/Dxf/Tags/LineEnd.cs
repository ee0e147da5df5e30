using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Engraver.Core.Dxf.Tags;

/// <summary>Finds the end of a line, sixteen bytes at a time.</summary>
internal static class LineEnd
{
    /// <summary>Bytes after the end found that may be read.</summary>
    private const int Margin = 32;

    /// <summary>Moves to the next LF or CR; false when there is none before the last bytes of the file (which need the general method).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool TryFind(ReadOnlySpan<byte> bytes, ref int at)
    {
        ref var first = ref MemoryMarshal.GetReference(bytes);
        for (var last = bytes.Length - Margin; at <= last; at += Vector128<byte>.Count)
        {
            var block = Vector128.LoadUnsafe(ref first, (nuint)at);
            var found = (Vector128.Equals(block, Vector128.Create((byte)'\n')) | Vector128.Equals(block, Vector128.Create((byte)'\r'))).ExtractMostSignificantBits();
            if (found == 0) continue;
            at += BitOperations.TrailingZeroCount(found);
            return true;
        }

        return false;
    }
}
