namespace Engraver.Core.Dxf;

/// <summary>The bytes of a file, of which the first ones are there while the others are still being read: a drawing is understood while it arrives.</summary>
public interface IArrivingBytes
{
    /// <summary>As long as the whole file. What has not arrived is undefined, and what has arrived stays as it is.</summary>
    byte[] Bytes { get; }

    /// <summary>Waits until so many bytes are there.</summary>
    /// <param name="count">0 to the length of the file.</param>
    /// <returns>How many are there, at least <paramref name="count"/>.</returns>
    /// <exception cref="IOException">The rest cannot be read, or the file is shorter than its length said.</exception>
    int WaitFor(int count);
}
