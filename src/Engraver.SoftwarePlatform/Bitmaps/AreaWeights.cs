namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>Weights of the source pixels <paramref name="First"/> to <paramref name="Last"/> in the mean over an interval; their sum is 1.</summary>
internal readonly record struct AreaWeights(int First, int Last, float FirstWeight, float InnerWeight, float LastWeight)
{
    public float this[int index] => index == First ? FirstWeight : index == Last ? LastWeight : InnerWeight;

    public static AreaWeights[] Along(int sourceLength, int targetLength)
    {
        var step = (double)sourceLength / targetLength;
        var weights = new AreaWeights[targetLength];
        for (var i = 0; i < targetLength; i++)
            weights[i] = Over(i * step, Math.Min(sourceLength, (i + 1) * step), sourceLength);
        return weights;
    }

    private static AreaWeights Over(double start, double end, int length)
    {
        var first = Math.Min((int)start, length - 1);
        var last = Math.Clamp((int)Math.Ceiling(end - 1e-9) - 1, first, length - 1);
        if (first == last)
            return new AreaWeights(first, last, 1, 1, 1);
        var whole = end - start;
        return new AreaWeights(first, last, (float)((first + 1 - start) / whole), (float)(1 / whole), (float)((end - last) / whole));
    }
}
