namespace Engraver.Core.Dxf;

/// <summary>The bytes of a file, of which the first ones are available while the others are still being read: a drawing is parsed while its file is
/// read.</summary>
public interface IProgressiveBytes
{
    /// <summary>An array with the length of the whole file. Bytes that have not arrived are undefined; bytes that have arrived do not change.</summary>
    byte[] Bytes { get; }

    /// <summary>Waits until this number of bytes has arrived.</summary>
    /// <param name="count">0 to the length of the file.</param>
    /// <returns>Number of bytes that have arrived, at least <paramref name="count"/>.</returns>
    /// <exception cref="IOException">The rest cannot be read, or the file is shorter than its stated length.</exception>
    int WaitFor(int count);
}
