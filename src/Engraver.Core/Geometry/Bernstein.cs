namespace Engraver.Core.Geometry;

/// <summary>Polynomials by their Bernstein coefficients, each multiplied by its binomial coefficient: a product is then a plain convolution, and the signs are
/// unchanged.</summary>
internal static class Bernstein
{
    /// <summary>Binomial coefficients up to twice the largest degree.</summary>
    public static double[][] Binomials { get; } = Pascal(2 * NurbsCurve.LargestDegree);

    /// <summary>The product of two polynomials; its length is the sum of both degrees plus 1.</summary>
    public static void Multiply(ReadOnlySpan<double> left, ReadOnlySpan<double> right, Span<double> product)
    {
        product.Clear();
        AddProduct(left, right, 1.0, product);
    }

    /// <summary>Adds <paramref name="factor"/> times a product to <paramref name="sum"/>.</summary>
    public static void AddProduct(ReadOnlySpan<double> left, ReadOnlySpan<double> right, double factor, Span<double> sum)
    {
        for (var i = 0; i < left.Length; i++)
        {
            var share = factor * left[i];
            for (var j = 0; j < right.Length; j++) sum[i + j] += share * right[j];
        }
    }

    /// <summary>The derivative, one degree lower.</summary>
    public static void Differentiate(ReadOnlySpan<double> polynomial, Span<double> derivative)
    {
        var degree = polynomial.Length - 1;
        for (var k = 0; k < degree; k++) derivative[k] = ((k + 1) * polynomial[k + 1]) - ((degree - k) * polynomial[k]);
    }

    /// <summary>Number of sign changes along the coefficients, without zeros: at least the number of roots between 0 and 1 (Descartes' rule of
    /// signs).</summary>
    /// <param name="first">Sign of the first coefficient that is not zero; 0 when all are zero.</param>
    public static int SignChanges(ReadOnlySpan<double> polynomial, out int first)
    {
        (first, var last, var changes) = (0, 0, 0);
        foreach (var coefficient in polynomial)
        {
            var sign = coefficient > 0.0 ? 1 : coefficient < 0.0 ? -1 : 0; // for a point too far away to be squared in a double this is NaN
            if (sign == 0) continue;
            if (first == 0) first = sign;
            else if (sign != last) changes++;
            last = sign;
        }

        return changes;
    }

    private static double[][] Pascal(int rows)
    {
        var table = new double[rows + 1][];
        for (var n = 0; n <= rows; n++)
        {
            table[n] = new double[n + 1];
            table[n][0] = table[n][n] = 1.0;
            for (var i = 1; i < n; i++) table[n][i] = table[n - 1][i - 1] + table[n - 1][i];
        }

        return table;
    }
}
