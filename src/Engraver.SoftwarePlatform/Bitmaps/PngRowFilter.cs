namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Undoes the row filters, which store a row as differences to its neighbours.</summary>
internal static class PngRowFilter
{
    /// <param name="row">Changed in place.</param>
    /// <param name="above">The row above, already unfiltered; zeros for the first.</param>
    public static void Undo(int filter, Span<byte> row, ReadOnlySpan<byte> above, int distance)
    {
        for (var i = 0; i < row.Length; i++)
        {
            var left = i >= distance ? row[i - distance] : 0;
            var aboveLeft = i >= distance ? above[i - distance] : 0;
            var prediction = filter switch
            {
                0 => 0,
                1 => left,
                2 => above[i],
                3 => (left + above[i]) / 2,
                4 => Paeth(left, above[i], aboveLeft),
                _ => throw new InvalidDataException("The PNG image has an unknown row filter."),
            };
            row[i] = (byte)(row[i] + prediction);
        }
    }

    /// <summary>The neighbour that is nearest to left + above - above left.</summary>
    private static int Paeth(int left, int above, int aboveLeft)
    {
        var estimate = left + above - aboveLeft;
        int toLeft = Math.Abs(estimate - left), toAbove = Math.Abs(estimate - above), toCorner = Math.Abs(estimate - aboveLeft);
        if (toLeft <= toAbove && toLeft <= toCorner)
            return left;
        return toAbove <= toCorner ? above : aboveLeft;
    }
}
