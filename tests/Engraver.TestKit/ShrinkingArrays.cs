using FsCheck;
using FsCheck.Fluent;

namespace Engraver.TestKit;

/// <summary>Arrays of generated items for properties. A counterexample is reduced to the items without which the property holds.</summary>
public static class ShrinkingArrays
{
    /// <summary>Arrays that are empty for the first case and grow from case to case.</summary>
    public static Arbitrary<T[]> ToArrays<T>(this Gen<T> items) => Arb.From(items.ArrayOf(), Shrunk(items));

    /// <summary>Arrays of at most <paramref name="size"/> items, for every case.</summary>
    public static Arbitrary<T[]> ToArrays<T>(this Gen<T> items, int size) => Arb.From(items.ArrayOf().Resize(size), Shrunk(items));

    private static Func<T[], IEnumerable<T[]>> Shrunk<T>(Gen<T> items) => items.ToArbitrary().Array().Shrinker;
}
