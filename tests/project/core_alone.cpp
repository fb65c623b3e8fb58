// A program with all of core in it and nothing else; core_knows_no_window.cmake looks at what it links.
int main()
{
    return 0;
}
