namespace Engraver.Core.Dxf;

/// <summary>Bytes of a text value to text, in the encoding of the file.</summary>
internal delegate string TextDecoding(ReadOnlySpan<byte> bytes);
