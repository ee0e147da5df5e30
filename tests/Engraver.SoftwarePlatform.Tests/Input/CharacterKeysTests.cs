using Avalonia.Input;
using Engraver.SoftwarePlatform.Input;

namespace Engraver.SoftwarePlatform.Tests.Input;

public sealed class CharacterKeysTests
{
    /// <summary>A US keyboard has 11 keys with two signs each, 26 letters and 10 digits; the shifted digits have no key here.</summary>
    [Fact]
    public void Both_signs_of_a_key_mean_that_key()
    {
        foreach (var (plain, shifted) in ",.-=/;[]\\`'".Zip("<>_+?:{}|~\""))
        {
            Assert.NotEqual(Key.None, CharacterKeys.KeyOf(plain));
            Assert.Equal(CharacterKeys.KeyOf(plain), CharacterKeys.KeyOf(shifted));
        }

        for (var letter = 'a'; letter <= 'z'; letter++)
        {
            Assert.Equal(Enum.Parse<Key>(char.ToUpperInvariant(letter).ToString()), CharacterKeys.KeyOf(letter));
            Assert.Equal(CharacterKeys.KeyOf(letter), CharacterKeys.KeyOf(char.ToUpperInvariant(letter)));
        }

        for (var digit = 0; digit <= 9; digit++) Assert.Equal(Enum.Parse<Key>($"D{digit}"), CharacterKeys.KeyOf('0' + digit));
    }

    [Theory]
    [InlineData('ö')]
    [InlineData('輪')]
    [InlineData('\t')]
    [InlineData('!')]
    [InlineData(0x1F600)]
    public void What_no_plain_key_carries_has_none(int character) => Assert.Equal(Key.None, CharacterKeys.KeyOf(character));
}
