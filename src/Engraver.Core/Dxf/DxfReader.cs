using System.Buffers;
using System.Runtime.InteropServices;
using System.Text;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Dxf.Tags;

namespace Engraver.Core.Dxf;

/// <summary>Reads a DXF of any version, ASCII or binary.</summary>
public static class DxfReader
{
    /// <summary>The known entity types, by how they are handled; docs/diagnostics.md lists them.</summary>
    public static IEnumerable<(string Fate, IEnumerable<string> Types)> TypeHandling => RecordKinds.Handling();

    private const int ShownStart = 24;

    /// <summary>Number of bytes from which a text is recognised.</summary>
    private const int FirstBytes = 64;

    private static readonly SearchValues<byte> VersionBytes = SearchValues.Create("0123456789."u8);

    /// <summary>
    /// Every curve of model space, blocks expanded, in drawing units. It returns a drawing for any input; whatever could not be read is in its balance and its
    /// diagnostics, each with type, handle and line. A bad entity is left out alone; all others are kept.
    /// </summary>
    /// <param name="file">The whole file.</param>
    /// <param name="fileName">Name for messages; no file is opened.</param>
    /// <param name="options">The operator's choices.</param>
    /// <param name="cancellation">Ends reading with an <see cref="OperationCanceledException"/>.</param>
    public static Drawing Read(ReadOnlyMemory<byte> file, string fileName, DxfReadOptions options, CancellationToken cancellation) => ReadWhole(new LoadedBytes(file), fileName, options, cancellation);

    /// <summary>The same for a file that is still being read: a text is parsed while it is read, any other file when it is complete.</summary>
    /// <inheritdoc cref="Read(ReadOnlyMemory{byte}, string, DxfReadOptions, CancellationToken)"/>
    /// <exception cref="IOException">The file cannot be read to its end, or has become shorter.</exception>
    public static Drawing Read(IProgressiveBytes file, string fileName, DxfReadOptions options, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(file);
        var length = file.Bytes.Length;
        file.WaitFor(Math.Min(FirstBytes, length));
        if (length >= FirstBytes && BeginsAsText(file.Bytes.AsSpan(0, FirstBytes))) return Read(new AsciiTagSource(file), file, fileName, options, cancellation);
        file.WaitFor(length);
        return ReadWhole(file, fileName, options, cancellation);
    }

    private static Drawing ReadWhole(IProgressiveBytes file, string fileName, DxfReadOptions options, CancellationToken cancellation)
    {
        ReadOnlySpan<byte> bytes = file.Bytes;
        if (bytes.IsEmpty) return Unreadable(fileName, 0, DxfRules.EmptyFile.At(default));
        if (IsDwg(bytes)) return Unreadable(fileName, bytes.Length, DxfRules.DwgFile.At(default, Encoding.ASCII.GetString(bytes[..6]).TrimEnd('\0')));
        if (BinaryTagSource.IsConverted(bytes)) return Unreadable(fileName, bytes.Length, DxfRules.BinaryConverted.At(default));
        if (ForeignFile.NameOf(bytes) is { } foreign) return Unreadable(fileName, bytes.Length, DxfRules.OtherFormat.At(default, foreign));
        return Read(TagsOf(file), file, fileName, options, cancellation);
    }

    private static Drawing Read(DxfTagSource tags, IProgressiveBytes file, string fileName, DxfReadOptions options, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(options);
        var import = new DrawingImport(tags, options, cancellation);
        return import.ReadSections()
            ? import.ToDrawing(fileName, file.Bytes.Length)
            : Unreadable(fileName, file.Bytes.Length, DxfRules.NotDxf.At(default, Beginning(file.Bytes)));
    }

    private static DxfTagSource TagsOf(IProgressiveBytes file)
    {
        if (file.Bytes.AsSpan().StartsWith(BinaryTagSource.Sentinel)) return new BinaryTagSource(file);
        var narrowed = WideText.ToUtf8(file.Bytes);
        return new AsciiTagSource(narrowed is null ? file : new LoadedBytes(narrowed)) { IsUtf8 = narrowed is not null || file.Bytes.AsSpan().StartsWith("\uFEFF"u8) };
    }

    /// <summary>True for a file that can only be a text of one byte per character: a group code of 0 or 999 comes first, with or without blanks before
    /// it.</summary>
    private static bool BeginsAsText(ReadOnlySpan<byte> bytes) => !bytes.Contains((byte)0) && bytes.TrimStart((byte)' ') is [(byte)'0' or (byte)'9', ..];

    /// <summary>True for a DWG, which begins with AC and four digits or dots (the first releases: MC0.0), then binary; in a DXF no version is in the first
    /// line.</summary>
    private static bool IsDwg(ReadOnlySpan<byte> bytes) =>
        bytes.Length > 6 && ((bytes.StartsWith("AC"u8) && bytes[2..6].IndexOfAnyExcept(VersionBytes) < 0) || bytes.StartsWith("MC0.0\0"u8));

    private static string Beginning(ReadOnlySpan<byte> bytes)
    {
        if (bytes.StartsWith(BinaryTagSource.Sentinel)) return Wording.Get("DxfReader.BinaryWithoutContent");
        var start = Encoding.Latin1.GetString(bytes[..Math.Min(ShownStart, bytes.Length)]);
        var shown = string.Join(' ', start.Split((char[])['\r', '\n', '\t', ' '], StringSplitOptions.RemoveEmptyEntries));
        return Wording.Get("DxfReader.NoSection", string.Concat(shown.Select(c => char.IsControl(c) ? '.' : c)));
    }

    private sealed class LoadedBytes(ReadOnlyMemory<byte> file) : IProgressiveBytes
    {
        public byte[] Bytes { get; } = MemoryMarshal.TryGetArray(file, out var segment) && segment.Offset == 0 && segment.Array!.Length == segment.Count ? segment.Array : file.ToArray();

        public int WaitFor(int count) => Bytes.Length;
    }

    private static Drawing Unreadable(string fileName, long bytes, Diagnostic why) => Drawing.Unusable(fileName, bytes, why);
}
