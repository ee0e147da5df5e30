namespace Engraver.Core.Dxf;

/// <summary>Decodes the bytes of a text value in the encoding of the file; escapes are not resolved.</summary>
internal delegate string TextDecoding(ReadOnlySpan<byte> bytes);
